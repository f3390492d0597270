#include <tests/core/gcm/gcm_fixture.h>

#include <latch>
#include <thread>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using test::FakeProcess;

class Membership : public test::GcmFixture {};

INSTANTIATE_TEST_SUITE_P(Over, Membership, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(Membership, JoiningAndReportingUpdatesTheCatalogue) {
  const auto robot = Join("robot", {test::Arm()});
  EXPECT_EQ(*gcm_->catalogue().FindComponent("robot", "arm"), test::Arm());

  robot->Add(test::Arm("second"));
  robot->Remove("arm");

  EXPECT_TRUE(EventuallyTrue([&] {
    const Catalogue catalogue = gcm_->catalogue();
    return catalogue.FindComponent("robot", "second") != nullptr &&
           catalogue.FindComponent("robot", "arm") == nullptr;
  }));
}

TEST_P(Membership, ExactlyOneOfAHundredEqualNamesJoins) {
  constexpr int kCount = 100;
  const auto middleware = NewMiddleware();
  std::vector<std::unique_ptr<FakeProcess>> processes;
  for (int i = 0; i < kCount; ++i) {
    processes.push_back(std::make_unique<FakeProcess>(middleware, "robot"));
  }
  std::latch start(kCount);
  std::mutex mutex;
  std::vector<std::uint64_t> winners;
  std::vector<Error> refusals;
  std::vector<std::thread> threads;
  for (const auto& process : processes) {
    threads.emplace_back([&] {
      start.arrive_and_wait();
      const auto joined = process->Join(address_);
      const std::scoped_lock lock(mutex);
      if (joined) {
        winners.push_back(process->description().instance);
      } else {
        refusals.push_back(joined.error());
      }
    });
  }
  for (std::thread& thread : threads) thread.join();

  ASSERT_EQ(winners.size(), 1U);
  EXPECT_EQ(gcm_->catalogue().FindProcess("robot")->process.instance, winners[0]);
  for (const Error& refusal : refusals) {
    EXPECT_EQ(refusal.code, ErrorCode::kExists);
    EXPECT_EQ(refusal.message.find("process name 'robot' is in use by host bench pid "), 0U);
  }
}

TEST_P(Membership, AKilledProcessIsLostAtOnceAndItsNameMayBeTaken) {
  auto robot = Join("robot", {test::Arm()});

  robot.reset();

  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("robot") == ProcessState::kLost; }));
  EXPECT_EQ(*gcm_->catalogue().FindComponent("robot", "arm"), test::Arm());
  const auto again = Join("robot", {});
  EXPECT_EQ(StateOf("robot"), ProcessState::kAlive);
  EXPECT_EQ(gcm_->catalogue().FindComponent("robot", "arm"), nullptr);
}

TEST_P(Membership, AHungProcessIsLostAndFencedAndCanJoinAgain) {
  const auto robot = Join("robot", {test::Arm()});
  Pass(800ms);
  EXPECT_EQ(StateOf("robot"), ProcessState::kSuspect);
  Pass(800ms);
  EXPECT_EQ(StateOf("robot"), ProcessState::kLost);
  EXPECT_TRUE(EventuallyTrue([&] { return !robot->is_linked(); }));

  // When the process runs again, it learns that it is no longer a member.
  EXPECT_FALSE(robot->Renew());
  ASSERT_TRUE(robot->Join(address_));

  EXPECT_EQ(StateOf("robot"), ProcessState::kAlive);
}

TEST_P(Membership, AReplacedProcessIsToldItsNamesHolder) {
  const auto zombie = Join("robot", {});
  Pass(1600ms);
  const auto heir = Join("robot", {});

  const auto joined = zombie->Join(address_);

  ASSERT_FALSE(joined);
  EXPECT_NE(joined.error().message.find("pid " + std::to_string(heir->description().pid)),
            std::string::npos);
  EXPECT_TRUE(heir->Renew());
}

TEST_P(Membership, RenewalsKeepALease) {
  const auto robot = Join("robot", {});
  for (int i = 0; i < 10; ++i) {
    Pass(500ms);
    ASSERT_TRUE(robot->Renew());
    ASSERT_EQ(StateOf("robot"), ProcessState::kAlive);
  }
}

TEST_P(Membership, AProcessMayRejoinOnASecondLink) {
  const auto robot = Join("robot", {test::Arm()});
  const std::uint64_t instance = robot->description().instance;

  // The process opens a second link before the GCM notices that the first one is broken.
  ASSERT_TRUE(robot->Join(address_));

  EXPECT_EQ(StateOf("robot"), ProcessState::kAlive);
  EXPECT_EQ(gcm_->catalogue().FindProcess("robot")->process.instance, instance);
  EXPECT_TRUE(robot->Renew());
}

TEST_P(Membership, AProcessThatLeftCanBeForgotten) {
  const auto robot = Join("robot", {test::Arm()});
  const auto client = Watch();

  ASSERT_TRUE(robot->Leave());
  EXPECT_EQ(StateOf("robot"), ProcessState::kLeft);
  robot->BreakLink();

  EXPECT_TRUE(Wait<void>(kLong, [&](auto handler) { client->Forget("robot", handler); }));
  EXPECT_EQ(gcm_->catalogue().FindProcess("robot"), nullptr);
}

TEST_P(Membership, JoiningReturnsAllPresentProcesses) {
  const auto desk = Join("desk", {});
  FakeProcess robot(NewMiddleware(), "robot");

  const auto joined = robot.Join(address_);

  ASSERT_TRUE(joined);
  ASSERT_EQ(joined->processes.size(), 2U);
  EXPECT_EQ(joined->processes[0].address, desk->description().address);
  EXPECT_EQ(joined->processes[1].name, "robot");
}

TEST_P(Membership, EveryProcessReceivesThePeersAddresses) {
  const auto desk = Join("desk", {});
  const auto seen = [&] {
    std::vector<std::string> names;
    for (const auto& peer : desk->peers().processes) names.push_back(peer.name + peer.address);
    return names;
  };
  EXPECT_TRUE(EventuallyTrue([&] { return seen().size() == 1; }));

  auto robot = Join("robot", {});
  const std::vector<std::string> both = {"desk" + desk->description().address,
                                         "robot" + robot->description().address};
  EXPECT_TRUE(EventuallyTrue([&] { return seen() == both; }));
  robot.reset();

  EXPECT_TRUE(EventuallyTrue([&] { return seen().size() == 1; }));
}

TEST_P(Membership, ASecondGcmKeepsTheHistoryOfTheFirst) {
  const std::string file =
      "history-127.0.0.1-" + address_.substr(address_.find(':') + 1) + ".jsonl";
  const std::string half_a_line = "{\"id\":1,\"verb\":\"con";  // a line that is being written
  folder_.Write(file, half_a_line);

  ASSERT_FALSE(GlobalManager::Start(
      NewMiddleware(), {.address = address_, .state_folder = folder_.path(), .clock = &clock_}));

  EXPECT_EQ(folder_.Read(file), half_a_line);
}

TEST_P(Membership, ASecondGcmAtTheAddressIsRefused) {
  const auto second = GlobalManager::Start(
      NewMiddleware(), {.address = address_, .state_folder = folder_.path(), .clock = &clock_});

  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kExists);
}

TEST_P(Membership, RefusesUnknownMessagesWithoutHarm) {
  const auto robot = Join("robot", {test::Arm()});
  const auto middleware = NewMiddleware();
  const auto handler = std::make_shared<ChannelHandler>();
  const auto channel =
      Channel::Open(*middleware, address_,
                    {.instance = 1, .name = "odd", .cookie = *LoopbackCookie()}, handler, kLong);
  ASSERT_TRUE(channel);
  const Bytes junk(100, std::byte{0xff});
  const std::uint64_t revision = gcm_->catalogue().revision();

  for (std::uint16_t type = 0x300; type < 0x330; ++type) {
    const auto reply = (*channel)->Call(static_cast<MessageType>(type), 0, junk, kLong);
    const bool has_no_body = type == 0x302 || type == 0x303 || type == 0x310 || type == 0x314 ||
                             type == 0x31a || type == 0x31c || type == 0x31d;
    EXPECT_EQ(reply.ok(), has_no_body) << type;
    EXPECT_TRUE((*channel)->Notify(static_cast<MessageType>(type), 0, junk));
  }

  EXPECT_TRUE(robot->Renew());
  EXPECT_EQ(gcm_->catalogue().revision(), revision);
}

TEST_P(Membership, AKilledGcmRecoversTheCatalogue) {
  const auto robot = Join("robot", {test::Arm()});
  const auto desk = Join("desk", {test::Teleoperation()});
  auto client = Watch();
  ASSERT_TRUE(Connect(*client));
  const Fingerprint before = gcm_->catalogue().ContentHash();
  const std::uint64_t instance = gcm_->instance();

  gcm_.reset();
  EXPECT_TRUE(EventuallyTrue([&] { return !robot->is_linked() && !desk->is_linked(); }));
  StartGcm(address_);
  EXPECT_NE(gcm_->catalogue().ContentHash(), before);
  ASSERT_TRUE(robot->Join(address_));
  ASSERT_TRUE(desk->Join(address_));

  EXPECT_EQ(gcm_->catalogue().ContentHash(), before);
  EXPECT_NE(gcm_->instance(), instance);
  EXPECT_EQ(desk->orders().size(), 1U);  // no connection was made twice
}

}  // namespace
}  // namespace tendon
