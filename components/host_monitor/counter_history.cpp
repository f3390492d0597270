#include <components/host_monitor/counter_history.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace host {
namespace {

constexpr std::chrono::seconds kWindow{1};
constexpr double kKib = 1024.0;
constexpr double kMib = 1024.0 * kKib;

double Load(const CpuTicks& before, const CpuTicks& now) {
  if (now.all <= before.all || now.busy < before.busy) return 0.0;
  const auto busy = static_cast<double>(now.busy - before.busy);
  return std::min(100.0, 100.0 * busy / static_cast<double>(now.all - before.all));
}

}  // namespace

void CounterHistory::Add(CounterSample sample) {
  samples_.push_back(std::move(sample));
  while (samples_.size() > 2 && samples_.back().time - samples_[1].time >= kWindow) {
    samples_.pop_front();
  }
}

void CounterHistory::Rate(Cpu& cpu) const {
  cpu.total = 0.0;
  std::fill(cpu.cores.begin(), cpu.cores.end(), 0.0);
  if (samples_.empty()) return;
  const CpuCounters& before = samples_.front().cpu;
  const CpuCounters& now = samples_.back().cpu;
  cpu.total = Load(before.total, now.total);
  const std::size_t cores = std::min({cpu.cores.size(), before.cores.size(), now.cores.size()});
  for (std::size_t core = 0; core < cores; ++core) {
    cpu.cores[core] = Load(before.cores[core], now.cores[core]);
  }
}

Disk CounterHistory::disk() const {
  if (samples_.empty()) return {};
  const DiskCounters& before = samples_.front().disk;
  const DiskCounters& now = samples_.back().disk;
  return {.read = PerSecond(before.read, now.read) / kMib,
          .written = PerSecond(before.written, now.written) / kMib};
}

Network CounterHistory::network() const {
  if (samples_.empty()) return {};
  const NetworkCounters& before = samples_.front().network;
  const NetworkCounters& now = samples_.back().network;
  return {.received = PerSecond(before.received, now.received) / kKib,
          .sent = PerSecond(before.sent, now.sent) / kKib,
          .loopback = PerSecond(before.loopback, now.loopback) / kKib};
}

double CounterHistory::PerSecond(std::uint64_t before, std::uint64_t now) const {
  const std::chrono::duration<double> passed = samples_.back().time - samples_.front().time;
  if (passed.count() <= 0.0 || now < before) return 0.0;
  return static_cast<double>(now - before) / passed.count();
}

}  // namespace host
