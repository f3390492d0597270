#pragma once

#include <chrono>
#include <thread>

namespace faults {

/// Returns how often a fault is injected: `small`, or `full` if TENDON_FULL_FAULTS is set.
int Size(int small, int full);

/// Like Size(), for programs that are started. A sanitizer starts them so slowly that fewer must be
/// enough.
int Starts(int small, int full);

/// Returns how much slower this machine starts a program of Tendon than an idle machine; at least
/// 1. Measured once, at the start. Under a sanitizer, always the largest value.
double Slowness();

/// Returns the time limit for one request of a failing test. It is not a requirement on speed.
std::chrono::milliseconds Timeout();

/// Waits until `predicate()` is true, at most three times as long as for a request, because other
/// tests may have begun after Slowness() was measured. Checks it rarely, so that the check does not
/// disturb the test.
template <typename Predicate>
bool Eventually(Predicate predicate) {
  const auto deadline = std::chrono::steady_clock::now() + 3 * Timeout();
  while (!predicate()) {
    if (std::chrono::steady_clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Measures the milliseconds since its construction.
class Stopwatch {
 public:
  [[nodiscard]] long milliseconds() const {
    const auto passed = std::chrono::steady_clock::now() - begin_;
    return std::chrono::duration_cast<std::chrono::milliseconds>(passed).count();
  }

 private:
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace faults
