#include <csignal>
#include <utility>

#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/footprint.h"

namespace faults {
namespace {

class Callers : public FaultTest {
 protected:
  /// Kills a program that waits for the end of a call while the call is executed.
  void KillOneInACall() {
    const std::size_t held = Lines("held");
    Program caller(Command("gcm", {"call", "robot/ledger/Control.Hold", "30"}), environment());
    ASSERT_TRUE(Eventually([&] { return Lines("held") > held; })) << caller.err();
    caller.Signal(SIGKILL);
    caller.Wait();
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Callers, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(Callers, KilledCallersLeakNothing) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  constexpr int kWarmUp = 3;
  for (int i = 0; i < kWarmUp; ++i) ASSERT_NO_FATAL_FAILURE(KillOneInACall());
  Footprint before;
  ASSERT_TRUE(Eventually([&] {  // waits until the killed callers have ended
    const Footprint earlier = std::exchange(before, FootprintOf(robot_->pid()));
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return earlier.descriptors == before.descriptors && earlier.threads == before.threads;
  }));
  const int rounds = Starts(12, 1000);

  for (int i = 0; i < rounds; ++i) ASSERT_NO_FATAL_FAILURE(KillOneInACall());

  Footprint after;
  EXPECT_TRUE(Eventually([&] {
    after = FootprintOf(robot_->pid());
    return IsFlat(before, after);
  })) << before
      << "; now " << after;
  // Each call was executed exactly once.
  EXPECT_EQ(Lines("held"), static_cast<std::size_t>(kWarmUp + rounds));
  ASSERT_TRUE(Flows());
  ExpectNoRowLost();
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
