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

/// All programs of this test have their own wall clock, which the test can set. Their steady clocks
/// are normal.
class Clock : public FaultTest {
 protected:
  void SetUp() override {
    const std::string library = TENDON_TEST_FAKETIME;
    if (library.empty()) GTEST_SKIP() << "there is no libfaketime: install the package faketime";
    if (tendon::test::IsSanitized()) {
      GTEST_SKIP() << "a sanitizer must be the first library, so libfaketime cannot be used";
    }
    Set("+0");
    more_environment_ = {{"LD_PRELOAD", library},
                         {"FAKETIME_TIMESTAMP_FILE", home_.path() / "clock"},
                         {"FAKETIME_NO_CACHE", "1"},
                         {"FAKETIME_DONT_FAKE_MONOTONIC", "1"},
                         {"DONT_FAKE_MONOTONIC", "1"}};
  }

  /// Sets the offset and the speed of the wall clocks. The change takes effect at once, because the
  /// programs read the clocks all the time.
  void Set(const std::string& offset) const {
    home_.Write("clock.new", offset + "\n");
    std::filesystem::rename(home_.path() / "clock.new", home_.path() / "clock");
  }
  /// Returns the difference of the GCM's clock from the test's clock, from the time at which a
  /// process has joined.
  [[nodiscard]] std::chrono::nanoseconds Difference() const {
    const auto mate = MakeLcm("mate");
    EXPECT_TRUE(EventuallyIs("mate", ProcessState::kAlive)) << mate->err();
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const std::chrono::nanoseconds since(viewer_->catalogue().FindProcess("mate")->process.since);
    // A process that does not know yet that it has joined would not leave the GCM.
    EXPECT_TRUE(Eventually([&] { return mate->err().find("joined") != std::string::npos; }));
    mate->Signal(SIGTERM);
    EXPECT_EQ(mate->Wait(), 0) << mate->err();
    EXPECT_TRUE(EventuallyIs("mate", ProcessState::kLeft));
    return since - now;
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Clock, testing::ValuesIn(Middlewares()), NameOfMiddleware);

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
