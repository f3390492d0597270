#pragma once

#include <benchmarks/case.h>
#include <tendon/base/result.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace tendon::benchmark {

/// Throws if the operation has failed, because there is then nothing to measure.
inline void RequireDone(const Result<void>& done) {
  if (!done) throw std::runtime_error(done.error().message);
}
template <typename T>
T Required(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return *std::move(result);
}

template <typename Action>
double NanosecondsEach(std::uint64_t times, Action action) {
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < times; ++i) action(i);
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  return took.count() / static_cast<double>(times);
}

/// Makes the compiler store `value` in memory, and assume that it is used.
template <typename T>
void Use(T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Repeats `attempt` until it succeeds; yields the processor if the thread that it depends on does
/// not seem to run.
template <typename Attempt>
void Insist(Attempt attempt) {
  constexpr int kSpins = 20'000;
  for (int failed = 1; !attempt(); ++failed) {
    if (failed % kSpins == 0) std::this_thread::yield();
  }
}

/// The value of `processors` for a subject that waits most of the time. For such a subject,
/// disturbances cannot be distinguished from its own waits.
inline constexpr double kSleeps = 0;

/// A function that runs one short repetition and returns what an operation took, in nanoseconds.
struct Subject {
  std::function<double()> run;
  /// The number of processors that the subject keeps busy if nothing disturbs it.
  double processors = 1;
  /// Returns the total processor time in seconds that other programs have used for the subject;
  /// null if there are none.
  std::function<double()> elsewhere = nullptr;
};

/// Runs both subjects one after the other, and alternates which one is first. Runs in a Seat on the
/// first processor.
std::function<std::optional<Pair>()> SideBySide(Subject ours, Subject floor);

/// Repeats the case until there are enough undisturbed pairs, and counts only these pairs. After
/// ten seconds it stops and counts all pairs. Empty if this machine cannot measure the case.
std::optional<Outcome> Measure(const Case& one, const Effort& effort);

/// The quantile: the value that this share of the values (0.5 for half) does not exceed.
double Quantile(std::vector<double> values, double share);

}  // namespace tendon::benchmark
