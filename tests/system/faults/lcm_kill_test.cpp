#include <csignal>

#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/footprint.h"

namespace faults {
namespace {

using tendon::ProcessState;

class LcmKill : public FaultTest {
 protected:
  static void Kill(Program& program) {
    program.Signal(SIGKILL);
    program.Wait();
  }
};

INSTANTIATE_TEST_SUITE_P(Over, LcmKill, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(LcmKill, AKilledLcmFreesItsNameAtOnce) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const auto rounds = static_cast<std::size_t>(Starts(4, 50));
  long longest = 0;  // ms

  for (std::size_t round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    Kill(*robot_);
    const Stopwatch since_death;
    robot_ = MakeLcm("robot");
    ASSERT_TRUE(Eventually([&] { return stream_->verdict().ledgers == 1 + round; }))
        << robot_->err();
    longest = std::max(longest, since_death.milliseconds());
    ASSERT_TRUE(EventuallyConnected());
    ASSERT_TRUE(Flows()) << robot_->err();
  }

  Tell(std::to_string(rounds) + " kills; rows of the next after " + std::to_string(longest) +
       " ms at most; " + ToString(stream_->verdict()));
  ExpectNeverLost("desk");
  if (!MayExpireLeases()) {
    EXPECT_EQ(watch_->Count("robot", ProcessState::kLost), rounds);
    EXPECT_EQ(watch_->Count("robot", ProcessState::kLeft), 0U);
    EXPECT_EQ(stream_->verdict().missing, 0U);
  }
  EXPECT_GE(stream_->verdict().stale.size(), rounds);
  EXPECT_LE(stream_->verdict().missing, stream_->verdict().counted);
  EXPECT_EQ(stream_->verdict().repeated, 0U);
  EXPECT_EQ(stream_->verdict().damaged, 0U);
  ExpectHonestCommands();
}

TEST_P(LcmKill, AKilledClientDoesNotHinderTheNext) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const Footprint before = FootprintOf(robot_->pid());
  const int rounds = Starts(4, 50);

  for (int round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    Kill(*desk_);
    desk_ = MakeLcm("desk");
    ASSERT_TRUE(Flows()) << desk_->err();
  }

  EXPECT_TRUE(Eventually([&] { return IsFlat(before, FootprintOf(robot_->pid())); }))
      << before << "; now " << FootprintOf(robot_->pid());
  ExpectNoRowLost();
  EXPECT_THAT(watch_->double_holders(), testing::IsEmpty());
  ExpectHonestCommands();
}

TEST_P(LcmKill, AChildProgramOfAComponentHoldsNoPort) {
  const std::string port = "127.0.0.1:" + std::to_string(FreePort());
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  robot_ = MakeLcm("robot", {"--listen", port});
  ASSERT_TRUE(EventuallyActive("robot", "ledger")) << robot_->err();
  const Outcome spawned = Gcm({"call", "robot/ledger/Control.Spawn"});
  ASSERT_EQ(spawned.exit_code, 0) << spawned.err;
  const pid_t child = std::stoi(spawned.out);
  ASSERT_GT(child, 0);  // kill() with 0 or less would signal other processes

  Kill(*robot_);
  const bool seen = EventuallyIs("robot", ProcessState::kLost);  // the end of its link is closed
  robot_ = MakeLcm("robot", {"--listen", port});
  const bool is_back = EventuallyIs("robot", ProcessState::kAlive);
  const bool outlived = kill(child, 0) == 0;
  kill(child, SIGKILL);

  EXPECT_TRUE(outlived);
  EXPECT_TRUE(seen);
  EXPECT_TRUE(is_back) << robot_->err();
}

}  // namespace
}  // namespace faults
