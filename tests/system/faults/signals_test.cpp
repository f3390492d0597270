#include <csignal>
#include <random>

#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

using testing::AnyOf;
using testing::Not;

class Signals : public FaultTest {
 protected:
  /// Sends a termination signal at a random time during the start or the life of a program. Returns
  /// the time until its end in ms.
  long EndAtARandomMoment(Program& program) {
    std::uniform_real_distribution<double> moment(0.0, 400.0 * Slowness());  // ms
    const int signal = random_() % 2 == 0 ? SIGTERM : SIGINT;
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(moment(random_)));
    const Stopwatch since_told;
    program.Signal(signal);
    const auto exit_code = program.Wait(std::chrono::ceil<std::chrono::seconds>(Timeout()));
    EXPECT_TRUE(exit_code) << "it goes on";
    // Before main() handles the signals, a signal kills the program.
    EXPECT_THAT(exit_code.value_or(-1), AnyOf(0, 128 + signal)) << program.err();
    EXPECT_THAT(program.err(), Not(testing::HasSubstr("terminate called")));
    return since_told.milliseconds();
  }

  std::mt19937 random_{4711};
};

INSTANTIATE_TEST_SUITE_P(Over, Signals, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(Signals, EndAnLcmInOrderAtAnyTime) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  robot_->Signal(SIGTERM);
  EXPECT_EQ(robot_->Wait(), 0);
  long longest = 0;  // ms

  for (int i = 0; i < Starts(12, 50); ++i) {
    robot_ = MakeLcm("robot");
    longest = std::max(longest, EndAtARandomMoment(*robot_));
  }

  Tell("the longest end took " + std::to_string(longest) + " ms");
  robot_ = MakeLcm("robot");
  ASSERT_TRUE(Flows()) << robot_->err();
  EXPECT_THAT(watch_->double_holders(), testing::IsEmpty());
  ExpectHonestCommands();
}

TEST_P(Signals, EndAGcmInOrderAtAnyTime) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  gcm_->Signal(SIGTERM);
  EXPECT_EQ(gcm_->Wait(), 0);
  long longest = 0;  // ms

  for (int i = 0; i < Starts(8, 50); ++i) {
    gcm_ = MakeGcm();
    longest = std::max(longest, EndAtARandomMoment(*gcm_));
  }

  Tell("the longest end took " + std::to_string(longest) + " ms");
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_TRUE(EventuallyIs("robot", tendon::ProcessState::kAlive));
  ASSERT_TRUE(Flows());
  ExpectNoRowLost();
  ExpectHonestCommands();
}

/// The first signal waits for a component that does not end.
TEST_P(Signals, ASecondSignalEndsAnLcmAtOnce) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const Program caller(Command("gcm", {"call", "robot/ledger/Control.Hold", "600000"}),
                       environment());
  ASSERT_TRUE(Eventually([&] { return Lines("held") == 1; }));
  robot_->Signal(SIGTERM);
  ASSERT_TRUE(EventuallyIs("robot", tendon::ProcessState::kLeft));

  robot_->Signal(SIGTERM);

  EXPECT_EQ(robot_->Wait(), 128 + SIGTERM);
}

}  // namespace
}  // namespace faults
