#include <tendon/base/os/process.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/viewer_messages.h>

#include <csignal>

#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

using tendon::Channel;
using tendon::ProcessState;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HungLcm : public FaultTest {
 protected:
  [[nodiscard]] bool IsConnectionActive() const {
    const auto catalogue = viewer_->catalogue();
    const auto* connection = catalogue.FindConnection({"desk", "client", "Ledger"});
    return connection != nullptr && connection->state == tendon::ConnectionState::kActive;
  }
};

INSTANTIATE_TEST_SUITE_P(Over, HungLcm, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(HungLcm, AStoppedLcmIsLostAndRejoins) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const auto rounds = static_cast<std::size_t>(Size(2, 20));
  long longest = 0;  // ms

  for (std::size_t round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    robot_->Signal(SIGSTOP);
    ASSERT_TRUE(EventuallyIs("robot", ProcessState::kLost));
    EXPECT_THAT(Gcm({"doctor"}).out, AllOf(HasSubstr("kill -CONT " + std::to_string(robot_->pid())),
                                           Not(HasSubstr("gcm forget"))));
    EXPECT_THAT(Gcm({"status"}).err, AllOf(HasSubstr("gcm doctor"), Not(HasSubstr("gcm forget"))));
    EXPECT_TRUE(Eventually([&] { return !IsConnectionActive(); }))
        << "it cannot stand without its process";
    std::this_thread::sleep_for(std::chrono::seconds(Size(0, 60)));
    const Stopwatch since_awake;
    robot_->Signal(SIGCONT);
    ASSERT_TRUE(EventuallyIs("robot", ProcessState::kAlive)) << robot_->err();
    longest = std::max(longest, since_awake.milliseconds());
    ASSERT_TRUE(EventuallyConnected());
    ASSERT_TRUE(Flows());
  }

  Tell(std::to_string(rounds) + " times stopped until lost; a member again after " +
       std::to_string(longest) + " ms at most; " + ToString(stream_->verdict()));
  EXPECT_THAT(watch_->double_holders(), testing::IsEmpty());
  if (!MayExpireLeases()) {
    EXPECT_GE(watch_->Count("robot", ProcessState::kSuspect), rounds) << "it was lost unsuspected";
  }
  EXPECT_EQ(stream_->verdict().ledgers, 1U);
  EXPECT_EQ(stream_->verdict().repeated, 0U);
  EXPECT_EQ(stream_->verdict().damaged, 0U);
  ExpectHonestCommands();
}

/// The process is stopped for less than its lease, so it remains a member.
TEST_P(HungLcm, ABrieflyStoppedLcmLosesNothing) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());

  for (int round = 0; round < Size(3, 30); ++round) {
    robot_->Signal(SIGSTOP);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    robot_->Signal(SIGCONT);
    ASSERT_TRUE(Flows());
  }

  ExpectNoRowLost();
  ExpectNeverLost("robot");
  ExpectHonestCommands();
}

/// The process reads the order only after the order has expired.
TEST_P(HungLcm, AResumedLcmDoesNotExecuteExpiredCommands) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  robot_->Signal(SIGSTOP);
  ASSERT_TRUE(Eventually([&] { return HasStopped(robot_->pid()); }));

  const auto stopped = tendon::Wait<void>(std::chrono::seconds(20), [&](auto handler) {
    viewer_->ExecuteLifecycleOrder({.verb = tendon::LifecycleVerb::kStop,
                                    .process = "robot",
                                    .component = "ledger",
                                    .timeout = std::chrono::milliseconds(200)},
                                   std::move(handler));
  });
  robot_->Signal(SIGCONT);

  ASSERT_FALSE(stopped);
  if (MayExpireLeases()) return;  // the process may have been lost before the command was sent
  EXPECT_EQ(stopped.error().code, tendon::ErrorCode::kFailed) << stopped.error().message;
  ASSERT_TRUE(Eventually([&] {
    return robot_->err().find("ordered remotely: stop 'ledger': nothing was done") !=
           std::string::npos;
  })) << robot_->err();
  EXPECT_TRUE(Flows());
  Tell(stopped.error().message);
}

TEST_P(HungLcm, AStoppedLcmAndGcmDoNotBlockOtherProcesses) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const auto middleware = NewMiddleware();
  const auto desk = Channel::Open(*middleware, AddressOf("desk"),
                                  {.instance = tendon::os::RandomNumber(),
                                   .name = "asker",
                                   .cookie = *tendon::LoopbackCookie()},
                                  std::make_shared<tendon::ChannelHandler>(), Timeout());
  ASSERT_TRUE(desk) << desk.error().message;
  const tendon::InterfaceName client("desk", "client", "Ledger");
  const auto says = [&](const std::string& words) {
    const auto counts = (*desk)->Call<tendon::ConnectionCounts>(
        tendon::message::kGetCounts, 0, tendon::message::GetCounts{client}, Timeout());
    return !counts && counts.error().message.find(words) != std::string::npos;
  };
  gcm_->Signal(SIGSTOP);
  robot_->Signal(SIGSTOP);
  ASSERT_TRUE(Eventually([&] { return says("cannot be reached"); })) << desk_->err();

  long longest = 0;  // ms
  const Stopwatch all;
  // Longer than the links to two hanging peers can block.
  while (all.milliseconds() < Size(2000, 60000)) {
    const Stopwatch one;
    ASSERT_TRUE(says("is pending"));
    longest = std::max(longest, one.milliseconds());
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  Tell("the desk answered within " + std::to_string(longest) + " ms");
  EXPECT_TRUE(Eventually([&] {
    return desk_->err().find("robot was disconnected: it has not answered for 1500 ms") !=
           std::string::npos;
  })) << desk_->err();
  robot_->Signal(SIGCONT);
  gcm_->Signal(SIGCONT);
  ASSERT_TRUE(Eventually([&] { return !says(""); })) << desk_->err();
  ASSERT_TRUE(EventuallyIs("robot", ProcessState::kAlive)) << robot_->err();
  ASSERT_TRUE(Flows());
  ExpectHonestCommands();
}

TEST_P(HungLcm, AReplacedLcmNamesItsSuccessorAndIsFenced) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  robot_->Signal(SIGSTOP);
  ASSERT_TRUE(EventuallyIs("robot", ProcessState::kLost));
  auto heir = MakeLcm("robot");
  ASSERT_TRUE(EventuallyIs("robot", ProcessState::kAlive)) << heir->err();
  ASSERT_TRUE(Eventually([&] { return stream_->verdict().ledgers == 2; }));
  ASSERT_TRUE(Flows());

  robot_->Signal(SIGCONT);  // the replaced process runs again
  ASSERT_TRUE(Eventually([&] {
    return robot_->err().find("keeps running, but is not registered") != std::string::npos;
  })) << robot_->err();
  EXPECT_THAT(robot_->err(), HasSubstr("pid " + std::to_string(heir->pid())));
  ASSERT_TRUE(Flows()) << "the heir is not disturbed";
  EXPECT_EQ(stream_->verdict().ledgers, 2U);

  heir->Signal(SIGKILL);
  heir->Wait();
  ASSERT_TRUE(Eventually([&] { return stream_->verdict().ledgers == 3; })) << robot_->err();
  ASSERT_TRUE(Flows()) << "the zombie is a member again";
  EXPECT_THAT(watch_->double_holders(), testing::IsEmpty());
  EXPECT_EQ(stream_->verdict().damaged, 0U);
  Tell("stopped, replaced, awake: " + ToString(stream_->verdict()));
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
