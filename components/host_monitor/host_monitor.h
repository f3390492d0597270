#pragma once

#include <components/host_monitor/counter_history.h>
#include <components/host_monitor/host_files.h>
#include <components/host_monitor/host_payloads.h>
#include <tendon/task/periodic_task.h>

#include <filesystem>
#include <string>

namespace host {

/// Measures the machine it runs on, at 20 Hz. Records `Cpu`, `Memory`, `Disk`, `Network` and, if
/// the machine has thermometers, `Temperatures`. Linux only: elsewhere every value is 0.
///
/// Not real-time: a cycle opens files and allocates.
class HostMonitor : public tendon::PeriodicTask {
 public:
  /// Reads the system files below `root`. The constructor decides which cores and thermometers are
  /// shown.
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
