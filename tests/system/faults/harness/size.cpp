#include "system/faults/harness/size.h"

#include <algorithm>
#include <cstdlib>

#include "support/machine/sanitized.h"
#include "support/program.h"

namespace faults {

int Size(int small, int full) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): read only
  static const bool is_full = std::getenv("TENDON_FULL_FAULTS") != nullptr;
  return is_full ? full : small;
}

int Starts(int small, int full) {
  return tendon::test::IsSanitized() ? std::max(std::min(small, 2), small / 3) : Size(small, full);
}

double Slowness() {
  static const double slowness = [] {
    constexpr int kRuns = 3;
    constexpr double kCalm = 30.0;  // ms per start
    constexpr double kSlowest = 6.0;
    if (tendon::test::IsSanitized()) return kSlowest;
    const Stopwatch watch;
    for (int i = 0; i < kRuns; ++i) RunProgram({Built("bin/lcm"), "--help"});
    return std::clamp(static_cast<double>(watch.milliseconds()) / kRuns / kCalm, 1.0, kSlowest);
  }();
  return slowness;
}

std::chrono::milliseconds Timeout() {
  constexpr double kCalm = 20'000.0;  // ms; ten times the longest limit of a test
  return std::chrono::milliseconds(static_cast<long>(kCalm * Slowness()));
}

}  // namespace faults
