#pragma once

#include <components/host_monitor/host_payloads.h>
#include <components/host_monitor/host_text.h>
#include <tendon/base/clock.h>

#include <deque>

namespace host {

/// All counters of a machine at one time.
struct CounterSample {
  tendon::SteadyTime time;
  CpuCounters cpu;
  DiskCounters disk;
  NetworkCounters network;
};

/// Makes rates of counters: what was counted in the last second, over the time that really lay
/// between the samples. A second, because a clock tick is 10 ms long: a twentieth of a second has
/// five of them, and a load made of five ticks is 0, 20 or 40 %.
class CounterHistory {
 public:
  /// `sample` is later than the one before.
  void Add(CounterSample sample);

  /// All are 0 until there are two samples, and where a counter went backwards: a device has gone,
  /// or the counter is full.
  void Rate(Cpu& cpu) const;
  [[nodiscard]] Disk disk() const;
  [[nodiscard]] Network network() const;

 private:
  /// Of something in bytes, in 1/s.
  [[nodiscard]] double PerSecond(std::uint64_t before, std::uint64_t now) const;

  std::deque<CounterSample> samples_;  // the first is a second older than the last
};

}  // namespace host
