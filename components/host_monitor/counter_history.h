#pragma once

#include <components/host_monitor/host_payloads.h>
#include <components/host_monitor/host_text.h>
#include <tendon/base/clock.h>

#include <cstdint>
#include <deque>

namespace host {

/// All counters of a machine at one time.
struct CounterSample {
  tendon::SteadyTime time;
  CpuCounters cpu;
  DiskCounters disk;
  NetworkCounters network;
};

/// Turns counters into rates. A rate is the difference over the last second, divided by the actual
/// time between the two samples. A shorter window would be too coarse: a clock tick lasts 10 ms, so
/// in a window of 50 ms a load could only be 0, 20, 40 % and so on.
class CounterHistory {
 public:
  /// `sample` must be later than the one before.
  void Add(CounterSample sample);

  /// All rates are 0 until there are two samples. A rate is also 0 if its counter went backwards,
  /// because a device was removed or the counter overflowed.
  void Rate(Cpu& cpu) const;
  [[nodiscard]] Disk disk() const;
  [[nodiscard]] Network network() const;

 private:
  /// The rate of a byte counter, in 1/s.
  [[nodiscard]] double PerSecond(std::uint64_t before, std::uint64_t now) const;

  std::deque<CounterSample> samples_;  // the first is one second older than the last
};

}  // namespace host
