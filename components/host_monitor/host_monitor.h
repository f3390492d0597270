#pragma once

#include <components/host_monitor/counter_history.h>
#include <components/host_monitor/host_files.h>
#include <components/host_monitor/host_payloads.h>
#include <tendon/task/periodic_task.h>

#include <filesystem>
#include <string>

namespace host {

/// Looks at the machine it runs on, at 20 Hz, and records `Cpu`, `Memory`, `Disk`, `Network` and,
/// where the machine has thermometers, `Temperatures`. Linux only: elsewhere everything is 0.
///
/// Not for real time: a cycle opens files and allocates.
class HostMonitor : public tendon::PeriodicTask {
 public:
  /// The files are looked for below `root`. The cores and thermometers found now are those that
  /// will be shown.
  explicit HostMonitor(std::string name, std::filesystem::path root = "/");

 private:
  void Startup() override { history_ = {}; }
  void Run() override;

  [[nodiscard]] CounterSample Sample() const;

  std::filesystem::path root_;
  Thermometers thermometers_;
  CounterHistory history_;

  Cpu cpu_;
  Memory memory_;
  Disk disk_;
  Network network_;
  Temperatures temperatures_;
};

}  // namespace host
