#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "support/machine/sanitized.h"
#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

using tendon::ProcessState;

/// All programs of this test have a clock of their own, which tells the time of day as the test
/// wants; how much time passes they know as everybody does.
class Clock : public FaultTest {
 protected:
  void SetUp() override {
    const std::string library = TENDON_TEST_FAKETIME;
    if (library.empty()) GTEST_SKIP() << "row 21: there is no libfaketime";
    if (tendon::test::IsSanitized()) {
      GTEST_SKIP() << "row 21: a sanitizer suffers no library before its own";
    }
    Set("+0");
    more_environment_ = {{"LD_PRELOAD", library},
                         {"FAKETIME_TIMESTAMP_FILE", home_.path() / "clock"},
                         {"FAKETIME_NO_CACHE", "1"},
                         {"FAKETIME_DONT_FAKE_MONOTONIC", "1"},
                         {"DONT_FAKE_MONOTONIC", "1"}};
  }

  /// How far the clocks go wrong, and how fast: at one instant, for they are read all the time.
  void Set(const std::string& offset) const {
    home_.Write("clock.new", offset + "\n");
    std::filesystem::rename(home_.path() / "clock.new", home_.path() / "clock");
  }
  /// By how much the GCM's clock differs from ours: it says when a process has joined.
  [[nodiscard]] std::chrono::nanoseconds Difference() const {
    const auto mate = MakeLcm("mate");
    EXPECT_TRUE(EventuallyIs("mate", ProcessState::kAlive)) << mate->err();
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const std::chrono::nanoseconds since(viewer_->catalogue().FindProcess("mate")->process.since);
    // Until it knows that it has joined it has nothing to leave.
    EXPECT_TRUE(Eventually([&] { return mate->err().find("joined") != std::string::npos; }));
    mate->Signal(SIGTERM);
    EXPECT_EQ(mate->Wait(), 0) << mate->err();
    EXPECT_TRUE(EventuallyIs("mate", ProcessState::kLeft));
    return since - now;
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Clock, testing::ValuesIn(Middlewares()), NameOfMiddleware);

/// Row 21.
TEST_P(Clock, AJumpingOrFastClockDoesNotDisturbTheSystem) {
  using std::chrono::days;
  using std::chrono::hours;
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  const std::vector<std::pair<std::string, days>> jumps{
      {"+1d", days(1)}, {"-1d", days(-1)}, {"+0 x1.001", days(0)}};

  for (const auto& [offset, expected] : jumps) {
    SCOPED_TRACE(offset);
    Set(offset);
    const auto difference = Difference();
    EXPECT_LT(std::chrono::abs(difference - expected), hours(1)) << "the clock was not changed";
    ASSERT_TRUE(Flows());
  }

  Tell(std::to_string(jumps.size()) + " times the clock went wrong; " +
       ToString(stream_->verdict()));
  ExpectNoRowLost();
  for (const char* name : {"robot", "desk"}) ExpectNeverLost(name);
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
