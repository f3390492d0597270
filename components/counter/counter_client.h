#pragma once

#include <tendon/interface/function.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace counter {

using namespace std::chrono_literals;

/// Reads a counter a hundred times a second, and resets it when it reaches a thousand.
class CounterClient final : public tendon::PeriodicTask {
 public:
  explicit CounterClient(std::string name) : PeriodicTask(std::move(name), 10ms) {
    state_table().Add(resets_, "Resets");
    auto& counter = AddRequiredInterface("Counter");
    counter.AddFunction(get_value_, "GetValue");
    counter.AddFunction(reset_, "Reset");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    std::int64_t value = 0;
    if (!get_value_(value)) return;  // not connected, or no value yet: try again next cycle
    if (value >= 1000 && reset_()) ++resets_;
  }

  tendon::ReadFunction<std::int64_t> get_value_;
  tendon::VoidFunction reset_;
  std::uint64_t resets_ = 0;
};

}  // namespace counter
