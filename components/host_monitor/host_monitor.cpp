#include <components/host_monitor/host_monitor.h>

#include <components/host_monitor/host_text.h>
#include <tendon/base/clock.h>
#include <tendon/payload/encoded_size.h>

#include <chrono>
#include <utility>

namespace host {
namespace {

constexpr std::chrono::milliseconds kPeriod{50};

}  // namespace

HostMonitor::HostMonitor(std::string name, std::filesystem::path root)
    : PeriodicTask(std::move(name), kPeriod), root_(std::move(root)), thermometers_(root_) {
  cpu_.cores.resize(Sample().cpu.cores.size());
  thermometers_.Read(temperatures_);

  state_table().Add(cpu_, "Cpu", tendon::EncodedSize(cpu_));
  state_table().Add(memory_, "Memory");
  state_table().Add(disk_, "Disk");
  state_table().Add(network_, "Network");
  if (thermometers_.empty()) return;
  state_table().Add(temperatures_, "Temperatures", tendon::EncodedSize(temperatures_));
}

void HostMonitor::Run() {
  ProcessQueuedCommands();
  history_.Add(Sample());
  history_.Rate(cpu_);
  disk_ = history_.disk();
  network_ = history_.network();
  memory_ = ParseMemory(ReadText(root_ / "proc/meminfo"));
  thermometers_.Read(temperatures_);
}

CounterSample HostMonitor::Sample() const {
  return {.time = tendon::SteadyClock().Now(),
          .cpu = ParseCpu(ReadText(root_ / "proc/stat")),
          .disk = ParseDisks(ReadText(root_ / "proc/diskstats")),
          .network = ParseNetwork(ReadText(root_ / "proc/net/dev"))};
}

}  // namespace host
