#pragma once

#include <tendon/task/periodic_task.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace counter {

using namespace std::chrono_literals;

/// Counts every millisecond, in steps that a client can set.
class Counter final : public tendon::PeriodicTask {
 public:
  explicit Counter(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(value_, "Value");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandVoid(&Counter::Reset, this, "Reset");
    control.AddCommandWrite(&Counter::SetStep, this, "SetStep");
    control.AddCommandReadState(state_table(), value_, "GetValue");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    value_ += step_;
  }
  void Reset() { value_ = 0; }
  void SetStep(std::int32_t step) { step_ = step; }

  std::int64_t value_ = 0;
  std::int32_t step_ = 1;
};

}  // namespace counter
