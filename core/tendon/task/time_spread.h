#pragma once

#include <tendon/task/cycle_statistics.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace tendon {

/// Collects times and computes their statistics. Percentiles are computed from a histogram of fixed
/// size, with 16 buckets for each power of two. Add() takes a few nanoseconds, Summary() and
/// Clear() take about a microsecond. Allocates no memory. Used by one thread.
class TimeSpread {
 public:
  /// Adds a time. A negative time counts as 0.
  void Add(std::chrono::nanoseconds time) noexcept;
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
  /// Returns the statistics. All values are 0 if no time was added.
  [[nodiscard]] TimeStatistics Summary() const noexcept;
  void Clear() noexcept { *this = TimeSpread(); }

 private:
  static constexpr unsigned kSubBits = 4;       // 16 buckets per power of two
  static constexpr unsigned kLongestBits = 42;  // the longest time is 2^42 ns (73 minutes)
  static constexpr std::size_t kBuckets = (kLongestBits - kSubBits + 1) << kSubBits;

  static std::size_t BucketOf(std::uint64_t time) noexcept;
  /// Returns the middle of a bucket in ns.
  static double MiddleOf(std::size_t bucket) noexcept;
  /// Returns a percentile in ns; `part` is 0.99 for the 99th.
  [[nodiscard]] double Percentile(double part) const noexcept;

  std::uint64_t count_ = 0;
  std::uint64_t min_ = 0;
  std::uint64_t max_ = 0;
  std::uint64_t first_ = 0;  // the sums use differences from this time, for precision
  double sum_ = 0.0;
  double squares_ = 0.0;
  std::array<std::uint32_t, kBuckets> buckets_{};
};

}  // namespace tendon
