#include <gmock/gmock.h>
#include <sys/stat.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <fstream>
#include <future>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using test::FakeProcess;
using test::kControl;
using test::kRobot;

class ConnectionOrders : public test::DeskAndRobot {};

INSTANTIATE_TEST_SUITE_P(Over, ConnectionOrders, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(ConnectionOrders, TheRequiredSidesProcessConnects) {
  const auto made = Connect(*client_);

  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->required, kRobot);
  EXPECT_EQ(made->provided, kControl);
  EXPECT_EQ(made->state, ConnectionState::kActive);
  EXPECT_EQ(Connection(), *made);
  ASSERT_EQ(desk_->orders().size(), 1U);
  EXPECT_EQ(desk_->orders()[0].address, robot_->description().address);
  EXPECT_EQ(desk_->orders()[0].instance, robot_->description().instance);
}

TEST_P(ConnectionOrders, ADisconnectEndsTheConnection) {
  ASSERT_TRUE(Connect(*client_));

  ASSERT_TRUE(Disconnect(*client_));

  EXPECT_EQ(desk_->connection_count(), 0U);
  EXPECT_FALSE(Connection());
  EXPECT_EQ(Disconnect(*client_).error().message,
            "desk/teleoperation/Robot is not connected: there is nothing to disconnect");
}

TEST_P(ConnectionOrders, ARefusedOrderLeavesNoTrace) {
  ASSERT_TRUE(Connect(*client_));
  const std::uint64_t revision = gcm_->catalogue().revision();
  const auto code = [&](const InterfaceName& required, const InterfaceName& provided) {
    const auto made = Connect(*client_, required, provided);
    return made ? ErrorCode::kFailed : made.error().code;
  };

  EXPECT_EQ(code(kRobot, {"robot", "arn", "Control"}), ErrorCode::kNotFound);
  EXPECT_EQ(code({"desk", "teleoperation", "Robbot"}, kControl), ErrorCode::kNotFound);
  EXPECT_EQ(code({"teleoperation", "Robot"}, kControl), ErrorCode::kInvalid);
  EXPECT_EQ(code(kRobot, kControl), ErrorCode::kExists);
  ASSERT_TRUE(Disconnect(*client_));
  EXPECT_EQ(code(kRobot, {"robot", "fake", "Control"}), ErrorCode::kIncompatible);

  EXPECT_EQ(desk_->orders().size(), 1U);
  EXPECT_EQ(Steps(*client_).size(), 2U);
  EXPECT_EQ(gcm_->catalogue().revision(), revision + 1);
}

TEST_P(ConnectionOrders, ForwardsARefusalWithoutRecordingAStep) {
  desk_->set_manners(FakeProcess::Manners::kRefuse);

  const auto made = Connect(*client_);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "teleoperation is busy");
  EXPECT_TRUE(Steps(*client_).empty());
  desk_->set_manners(FakeProcess::Manners::kObey);
  EXPECT_TRUE(Connect(*client_));
}

TEST_P(ConnectionOrders, AProcessDyingBeforeItsReplyIsAnError) {
  desk_->set_manners(FakeProcess::Manners::kSayNothing);
  std::promise<Result<ConnectionDescription>> promise;
  auto future = promise.get_future();
  client_->Connect(kRobot, kControl, [&](auto made) { promise.set_value(std::move(made)); });
  ASSERT_TRUE(EventuallyTrue([&] { return desk_->orders().size() == 1; }));
  const auto second = Connect(*client_);

  desk_.reset();
  const auto made = future.get();

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kUnreachable) << made.error().message;
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message,
            "desk/teleoperation/Robot is being changed by another request; try again when that "
            "request is done");
  EXPECT_TRUE(Steps(*client_).empty());
}

TEST_P(ConnectionOrders, AnUnresponsiveProcessIsATimeout) {
  order_timeout_ = 1s;  // within which a busy machine obeys
  RestartGcm();
  desk_->set_manners(FakeProcess::Manners::kSayNothing);

  const auto made = Connect(*client_);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kTimeout);
  EXPECT_NE(made.error().message.find("desk"), std::string::npos) << made.error().message;
  desk_->set_manners(FakeProcess::Manners::kObey);
  EXPECT_TRUE(Connect(*client_));
}

TEST(OrderTimeout, IsShorterThanTheClientsTimeout) {
  EXPECT_LT(GlobalManager::Options().order_timeout, GcmClient::Options().timeout);
}

TEST_P(ConnectionOrders, ConnectingToALostProcessIsPending) {
  robot_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("robot") == ProcessState::kLost; }));

  const auto made = Connect(*client_);

  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->state, ConnectionState::kPending);
  EXPECT_EQ(desk_->orders()[0].address, "");
}

TEST_P(ConnectionOrders, ConnectingToAnUnknownProcessIsPending) {
  const auto made = Connect(*client_, kRobot, {"never", "arm", "Control"});

  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->state, ConnectionState::kPending);
  EXPECT_EQ(desk_->orders()[0].address, "");
  EXPECT_EQ(Steps(*client_).size(), 1U);
  EXPECT_EQ(Connect(*client_).error().code, ErrorCode::kExists);
}

TEST_P(ConnectionOrders, ARefusalNamesTheFirstTypeDifference) {
  // A new type for each parameter, because types of other tests are known already.
  const std::string unit = "rad/" + GetParam();
  robot_->Know(test::GoalIn("deg"));
  robot_->Add(test::Mover(test::GoalIn("deg")));
  desk_->Know(test::GoalIn(unit));
  desk_->Add(test::Leader(test::GoalIn(unit)));
  const auto aide = Join("aide", {test::Leader(test::GoalIn("gon/" + GetParam()))});
  const InterfaceName leader("desk", "leader", "Mover");
  const InterfaceName mover("robot", "mover", "Control");
  ASSERT_TRUE(EventuallyTrue([&] {
    const Catalogue catalogue = gcm_->catalogue();
    return catalogue.FindRequired(leader) != nullptr && catalogue.FindProvided(mover) != nullptr;
  }));

  const Error refusal{
      ErrorCode::kIncompatible,
      "desk/leader/Mover does not fit robot/mover/Control: needs write command 'MoveTo' of "
      "test.Goal, but the provider offers another test.Goal (position of test.Goal: float64 in " +
          unit + " needed, float64 in deg offered)"};
  int tries = 0;  // the GCM waits only briefly, so on a machine that stalls one try is not enough
  std::optional<Error> why;

  EXPECT_TRUE(EventuallyTrue([&] {
    ++tries;
    const auto made = Connect(*client_, leader, mover);
    why = made ? std::nullopt : std::optional(made.error());
    return why == refusal;
  })) << (why ? why->message : "connected");

  EXPECT_TRUE(desk_->orders().empty());
  // No request if the test is repeated and the type is known.
  EXPECT_LE(desk_->schema_requests(), tries);
  EXPECT_EQ(aide->schema_requests(), 0);  // this process has no part in the connection
}

TEST_P(ConnectionOrders, ARefusalOmitsTypesThatAnEndDoesNotReport) {
  const std::string unit = "grad/" + GetParam();
  robot_->Add(test::Mover(test::GoalIn("deg")));
  desk_->Add(test::Leader(test::GoalIn(unit)));  // a type that desk does not know itself
  const InterfaceName leader("desk", "leader", "Mover");
  ASSERT_TRUE(EventuallyTrue([&] {
    return gcm_->catalogue().FindRequired(leader) != nullptr &&
           gcm_->catalogue().FindComponent("robot", "mover") != nullptr;
  }));

  const auto made = Connect(*client_, leader, {"robot", "mover", "Control"});

  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("(fields, units or shapes differ)"), std::string::npos)
      << made.error().message;
}

TEST_P(ConnectionOrders, RestoresTheConnectionsOfARestartedProcess) {
  ASSERT_TRUE(Connect(*client_));
  desk_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("desk") == ProcessState::kLost; }));

  desk_ = Join("desk", {});
  EXPECT_FALSE(Connection());
  desk_->Add(test::Teleoperation());

  EXPECT_TRUE(EventuallyTrue([&] { return Connection().has_value(); }));
  EXPECT_EQ(desk_->orders().size(), 1U);
  EXPECT_EQ(Steps(*client_).size(), 1U);
}

TEST_P(ConnectionOrders, RetriesRestoringAConnection) {
  ASSERT_TRUE(Connect(*client_));
  desk_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("desk") == ProcessState::kLost; }));
  desk_ = std::make_unique<FakeProcess>(NewMiddleware(), "desk");
  desk_->Add(test::Teleoperation());
  desk_->set_manners(FakeProcess::Manners::kRefuse);
  ASSERT_TRUE(desk_->Join(address_));
  ASSERT_TRUE(EventuallyTrue([&] { return desk_->orders().size() == 1; }));

  desk_->set_manners(FakeProcess::Manners::kObey);

  EXPECT_TRUE(EventuallyTrue([&] {
    EXPECT_TRUE(robot_->Renew());
    EXPECT_TRUE(desk_->Renew());
    Pass(50ms);
    return Connection().has_value();
  }));
  EXPECT_EQ(desk_->orders().size(), 2U);
}

TEST_P(ConnectionOrders, AHungDiskDelaysTheReplyButNoLease) {
  const std::string port = address_.substr(address_.find(':') + 1);
  const auto file = folder_.path() / ("history-127.0.0.1-" + port + ".jsonl");
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);  // opening the pipe blocks until it is read
  std::promise<Result<ConnectionDescription>> promise;
  auto reply = promise.get_future();
  client_->Connect(kRobot, kControl, [&](auto made) { promise.set_value(std::move(made)); });
  ASSERT_TRUE(EventuallyTrue([&] { return Connection().has_value(); }));

  // The GCM ticks in its own thread, with the simulated time of this test.
  EXPECT_TRUE(EventuallyTrue([&] {
    clock_.Advance(1ms);
    return StateOf("robot") == ProcessState::kLost;
  }));
  EXPECT_EQ(Steps(*client_).size(), 1U);  // the step is known, although it was not saved
  EXPECT_EQ(reply.wait_for(0ms), std::future_status::timeout);

  const std::ifstream disk_that_works_again(file);
  EXPECT_TRUE(reply.get());
}

TEST_P(ConnectionOrders, HistoryRecordsActionAuthorAndTime) {
  ASSERT_TRUE(Connect(*client_));
  ASSERT_TRUE(Disconnect(*client_));

  const auto steps = Steps(*client_);

  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].verb, "connect");
  EXPECT_EQ(steps[1].verb, "disconnect");
  for (const auto& step : steps) {
    EXPECT_EQ(step.ends, (message::ConnectionEnds{kRobot, kControl}));
    EXPECT_EQ(step.who, "gcm connect");
    EXPECT_GT(step.when, 1'700'000'000'000'000'000);
    EXPECT_FALSE(step.undone);
  }
}

TEST_P(ConnectionOrders, UndoRevertsStepsOneByOne) {
  EXPECT_EQ(Undo(*client_).error().message, "there is nothing to undo");
  ASSERT_TRUE(Connect(*client_));
  ASSERT_TRUE(Disconnect(*client_));

  const auto first = Undo(*client_);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->verb, "disconnect");
  EXPECT_TRUE(first->undone);
  EXPECT_TRUE(Connection());
  const auto second = Undo(*client_);
  ASSERT_TRUE(second) << second.error().message;

  EXPECT_EQ(second->verb, "connect");
  EXPECT_FALSE(Connection());
  EXPECT_FALSE(Undo(*client_));
}

TEST_P(ConnectionOrders, FiftyConnectsAndUndosRestoreTheSystem) {
  constexpr int kCount = 50;
  ComponentDescription panel = test::Teleoperation("panel");
  panel.required.clear();
  for (int i = 0; i < kCount; ++i) panel.required.push_back(test::Robot("R" + std::to_string(i)));
  const auto wall = Join("wall", {panel});
  const Fingerprint before = gcm_->catalogue().ContentHash();

  for (int i = 0; i < kCount; ++i) {
    ASSERT_TRUE(Connect(*client_, {"wall", "panel", "R" + std::to_string(i)}));
  }
  EXPECT_NE(gcm_->catalogue().ContentHash(), before);
  for (int i = 0; i < kCount; ++i) {
    const auto undone = Undo(*client_);
    ASSERT_TRUE(undone) << undone.error().message;
  }

  EXPECT_EQ(gcm_->catalogue().ContentHash(), before);
}

TEST_P(ConnectionOrders, AnUndoIsRefusedIfTheConnectionHasChanged) {
  ComponentDescription second = test::Arm("second");
  robot_->Add(second);
  ASSERT_TRUE(EventuallyTrue([&] { return gcm_->catalogue().FindComponent("robot", "second"); }));
  ASSERT_TRUE(Connect(*client_));
  // The process connects the interface to another one without an order of the GCM.
  const ConnectionDescription other{.id = Connection()->id,
                                    .required = kRobot,
                                    .provided = {"robot", "second", "Control"},
                                    .state = ConnectionState::kActive};
  desk_->Report({{.kind = CatalogueChange::Kind::kConnection, .connections = {other}}});
  ASSERT_TRUE(EventuallyTrue([&] { return Connection() == other; }));
  EXPECT_THAT(
      Undo(*client_).error().message,
      testing::HasSubstr("): desk/teleoperation/Robot is now connected to robot/second/Control; "));

  desk_->Report({{.kind = CatalogueChange::Kind::kConnectionRemoved, .connection = other.id}});
  ASSERT_TRUE(EventuallyTrue([&] { return !Connection(); }));
  EXPECT_THAT(Undo(*client_).error().message,
              testing::HasSubstr(
                  "): desk/teleoperation/Robot is no longer connected to robot/arm/Control; "));
  EXPECT_FALSE(Steps(*client_)[0].undone);
}

TEST_P(ConnectionOrders, StepsCanBeUndoneAfterAGcmRestart) {
  ASSERT_TRUE(Connect(*client_));
  RestartGcm();

  const auto undone = Undo(*client_);

  ASSERT_TRUE(undone) << undone.error().message;
  EXPECT_EQ(undone->who, "gcm connect");
  EXPECT_FALSE(Connection());
}

}  // namespace
}  // namespace tendon
