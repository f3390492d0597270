#pragma once

#include <benchmarks/case.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>

namespace tendon::benchmark {

template <typename Action>
double NanosecondsEach(std::uint64_t times, Action action) {
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < times; ++i) action(i);
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
  return took.count() / static_cast<double>(times);
}

/// The compiler must have `value` ready in memory, and believe that it is used.
template <typename T>
void Use(T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Until `attempt` succeeds; gives way when whoever is to make that possible seems not to run.
template <typename Attempt>
void Insist(Attempt attempt) {
  constexpr int kPatience = 20'000;
  for (int failed = 1; !attempt(); ++failed) {
    if (failed % kPatience == 0) std::this_thread::yield();
  }
}

/// Of a subject that waits most of the time: what disturbs it cannot be told from what it does.
inline constexpr double kSleeps = 0;

/// A function that runs one short repetition and returns what an operation took, in nanoseconds.
struct Subject {
  std::function<double()> run;
  /// Processors it keeps busy when nothing disturbs it.
  double processors = 1;
  /// The seconds of processor time used for it, ever, outside this program; or nothing.
  std::function<double()> elsewhere = nullptr;
};

/// Runs one after the other, each first in turns, in a Seat on the first processor.
std::function<std::optional<Pair>()> SideBySide(Subject ours, Subject floor);

/// Repeats the case until there are enough undisturbed pairs, which alone count then, or until ten
/// seconds have passed: then all of them count. Nothing where this machine cannot tell.
std::optional<Outcome> Measure(const Case& one, const Effort& effort);

/// The value that a share of them, 0.5 for half, does not exceed.
double Quantile(std::vector<double> values, double share);

}  // namespace tendon::benchmark
