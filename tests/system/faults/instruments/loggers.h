#pragma once

#include <tendon/base/log.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace faults {

/// Logs 100 000 lines per second.
class Raver final : public tendon::PeriodicTask {
 public:
  explicit Raver(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(1)) {}

 private:
  void Run() override {
    ProcessQueuedCommands();
    for (int i = 0; i < 100; ++i) tendon::Log(tendon::LogLevel::kWarning, name(), "hot");
  }
};

/// Logs a counter every 20 ms.
class Calm final : public tendon::PeriodicTask {
 public:
  explicit Calm(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(20)) {}

 private:
  void Run() override {
    ProcessQueuedCommands();
    tendon::Log(tendon::LogLevel::kInfo, name(), std::to_string(++number_));
  }

  std::uint64_t number_ = 0;
};

}  // namespace faults
