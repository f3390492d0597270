#include <tendon/gcm/client/process_links.h>
#include <tendon/interface/compatibility.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <atomic>
#include <future>

namespace tendon {
namespace {

using test::FakeProcess;

class Client : public test::GcmFixture {
 protected:
  void SetUp() override {
    robot_ = Join("robot", {test::Arm()});
    client_ = Watch();
  }

  Result<std::string> Call(const std::string& path, const std::string& argument = {}) {
    return Wait<std::string>(kLong, [&](auto handler) { client_->Call(path, argument, handler); });
  }
  std::string CallError(const std::string& path, const std::string& argument = {}) {
    const auto reply = Call(path, argument);
    return reply ? "no error: " + *reply : reply.error().message;
  }

  std::unique_ptr<FakeProcess> robot_;
  std::unique_ptr<GcmClient> client_;
};

INSTANTIATE_TEST_SUITE_P(Over, Client, testing::Values("loopback", "tcp"), test::NameOfParameter);

TEST_P(Client, ReadsCommandsAndColumnsAsJson) {
  EXPECT_EQ(*Call("robot/arm/Control.GetJoints"), "[1,2,3,4,5,6,7]");
  EXPECT_EQ(*Call("robot/arm/state.Joints"), "[1,2,3,4,5,6,7]");
  EXPECT_EQ(*Call("robot/arm/state.Joints[2]"), "3");
  EXPECT_EQ(CallError("robot/arm/state.Joints[7]"), "there is no element [7]");
}

TEST_P(Client, GivesArgumentsAsJson) {
  EXPECT_EQ(*Call("robot/arm/Control.Scale", "2"), "[2,4,6,8,10,12,14]");
  EXPECT_EQ(*Call("robot/arm/Control.MoveTo", "[7,6,5,4,3,2,1]"), "");
  EXPECT_EQ(robot_->goal(), (test::Joints{7, 6, 5, 4, 3, 2, 1}));
}

TEST_P(Client, RefusesAMismatchedArgumentBeforeSending) {
  EXPECT_EQ(CallError("robot/arm/Control.MoveTo", "[1,2]").find("robot/arm/Control.MoveTo: "), 0U);
  EXPECT_EQ(CallError("robot/arm/Control.MoveTo", "{").find("robot/arm/Control.MoveTo: "), 0U);
  EXPECT_EQ(CallError("robot/arm/Control.MoveTo"),
            "robot/arm/Control.MoveTo needs an argument of float64[7] as JSON; gcm show "
            "robot/arm/Control.MoveTo prints an example");
  EXPECT_EQ(CallError("robot/arm/Control.GetJoints", "1"),
            "robot/arm/Control.GetJoints takes no argument");
  EXPECT_FALSE(robot_->goal());
}

TEST_P(Client, FindsTheDifferenceOfTwoTypesWithOneName) {
  const Schema needed = test::GoalIn("rev/" + GetParam());
  const Schema offered = test::GoalIn("mm/" + GetParam());
  robot_->Know(offered);
  robot_->Know(needed);
  robot_->Add(test::Mover(offered));
  robot_->Add(test::Leader(needed));
  const auto words = [this] {
    const Catalogue catalogue = client_->catalogue();
    const auto* leader = catalogue.FindRequired({"robot", "leader", "Mover"});
    const auto* mover = catalogue.FindProvided({"robot", "mover", "Control"});
    return leader == nullptr || mover == nullptr ? "" : Compare(*leader, *mover).Text();
  };
  ASSERT_TRUE(EventuallyTrue([&] { return !words().empty(); }));
  EXPECT_NE(words().find("fields, units or shapes differ"), std::string::npos) << words();

  const auto learn = [this] {
    return bool(
        Wait<void>(kLong, [this](auto handler) { client_->LearnConflictingTypes(handler); }));
  };
  // The client waits only briefly for a process. On a machine that stalls, one attempt is not
  // enough.
  EXPECT_TRUE(EventuallyTrue([&] {
    return learn() && words().find("float64 in rev/" + GetParam() + " needed") != std::string::npos;
  })) << words();
  const int asked = robot_->schema_requests();
  EXPECT_TRUE(learn());
  EXPECT_EQ(robot_->schema_requests(), asked);  // all types are known already
}

TEST_P(Client, ConcurrentTypeComparisonsShareTheirRequests) {
  // A type that the robot does not know.
  robot_->Add(test::Mover(test::GoalIn("in/" + GetParam())));
  robot_->Add(test::Leader(test::GoalIn("ft/" + GetParam())));
  ASSERT_TRUE(EventuallyTrue([this] {
    const Catalogue catalogue = client_->catalogue();
    return catalogue.FindComponent("robot", "leader") && catalogue.FindComponent("robot", "mover");
  }));
  constexpr int kCrowd = 100;
  std::atomic<int> answered{0};

  for (int i = 0; i < kCrowd; ++i) {
    client_->LearnConflictingTypes([&answered](const auto& /*learned*/) { ++answered; });
  }

  EXPECT_TRUE(EventuallyTrue([&] { return answered == kCrowd; }));
  EXPECT_GE(robot_->schema_requests(), 1);
  EXPECT_LT(robot_->schema_requests(), kCrowd / 2);
}

TEST_P(Client, AFailureStatusIsAnError) {
  const auto stopped = Call("robot/arm/Control.Stop");
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().message,
            "robot/arm/Control.Stop: not active; start the component of this command first");
}

TEST_P(Client, ProcessUpdatesKeepAChannelToTheSameInstance) {
  const auto middleware = NewMiddleware();
  const auto links = std::make_shared<client::ProcessLinks>(
      *middleware,
      [this](const std::string&) { return Result<ProcessDescription>(robot_->description()); },
      client::ProcessLinks::Options{.name = "test"});
  std::promise<std::shared_ptr<Channel>> promise;
  links->WithChannel("robot", [&](const auto& channel) { promise.set_value(*channel); });
  const auto channel = promise.get_future().get();

  // The request may be faster than the snapshot that contains the process.
  links->Drop("robot", robot_->description().instance);
  EXPECT_TRUE(channel->is_open());

  links->Drop("robot", robot_->description().instance + 1);
  EXPECT_TRUE(EventuallyTrue([&] { return !channel->is_open(); }));
  links->Stop();
}

TEST_P(Client, AWrongPathIsReportedWithASuggestion) {
  EXPECT_EQ(CallError("robott/arm/Control.Stop"), "no process 'robott'; did you mean 'robot'?");
  EXPECT_EQ(CallError("robot/arm/Control.Stopp"),
            "no command 'robot/arm/Control.Stopp'; did you mean 'Stop'?");
  EXPECT_EQ(CallError("robot/arm"),
            "'robot/arm' does not name a command: expected process/component/interface.member");
  EXPECT_EQ(CallError("").find("'' is not a path"), 0U);
}

TEST_P(Client, RequestsASchemaOnce) {
  const auto get = [&](Fingerprint fingerprint) {
    return Wait<Schema>(kLong,
                        [&](auto handler) { client_->GetSchema("robot", fingerprint, handler); });
  };

  const auto schema = get(FingerprintOf<test::Joints>());
  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(*schema, SchemaOf<test::Joints>());
  EXPECT_TRUE(get(FingerprintOf<test::Joints>()));
  EXPECT_TRUE(Call("robot/arm/Control.GetJoints"));
  EXPECT_EQ(robot_->schema_requests(), 1);

  const auto unknown = get(FingerprintOf<std::string>());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::kNotFound);
}

TEST_P(Client, ReportsThatAProcessIsLost) {
  ASSERT_TRUE(Call("robot/arm/Control.GetJoints"));
  robot_.reset();
  ASSERT_TRUE(EventuallyTrue([&] {
    return client_->catalogue().FindProcess("robot")->process.state == ProcessState::kLost;
  }));

  EXPECT_EQ(CallError("robot/arm/Control.GetJoints").find("process 'robot' is lost ("), 0U);
}

TEST_P(Client, ReachesARestartedProcessAtItsNewAddress) {
  ASSERT_TRUE(Call("robot/arm/Control.GetJoints"));
  const std::uint64_t before = robot_->description().instance;
  robot_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("robot") == ProcessState::kLost; }));
  robot_ = Join("robot", {test::Arm()});
  ASSERT_TRUE(EventuallyTrue([&] {
    const Catalogue catalogue = client_->catalogue();
    return catalogue.FindProcess("robot")->process.instance != before &&
           catalogue.FindComponent("robot", "arm") != nullptr;
  }));

  EXPECT_EQ(*Call("robot/arm/state.Joints[0]"), "1");
}

TEST_P(Client, CallsEachHandlerOnceEvenOnDestruction) {
  const auto desk = Join("desk", {test::Teleoperation()});
  ASSERT_TRUE(EventuallyTrue([&] { return client_->catalogue().FindProcess("desk") != nullptr; }));
  desk->set_manners(FakeProcess::Manners::kSayNothing);
  constexpr int kCount = 50;
  std::mutex mutex;
  std::map<int, int> calls;
  const auto count = [&](int number) {
    return [&, number](const auto& /*result*/) {
      const std::scoped_lock lock(mutex);
      ++calls[number];
    };
  };
  for (int i = 0; i < kCount; ++i) {
    client_->Connect(test::kRobot, test::kControl, count(4 * i));
    client_->Call("robot/arm/Control.GetJoints", "", count(4 * i + 1));
    client_->Call("nowhere/arm/Control.GetJoints", "", count(4 * i + 2));
    client_->GetSchema("robot", FingerprintOf<double>(), count(4 * i + 3));
  }

  client_.reset();

  const std::scoped_lock lock(mutex);
  ASSERT_EQ(calls.size(), 4U * kCount);
  for (const auto& [number, times] : calls) EXPECT_EQ(times, 1) << number;
}

}  // namespace
}  // namespace tendon
