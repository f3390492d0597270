#pragma once

#include <tendon/task/periodic_task.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

using namespace std::chrono_literals;

/// A sine, computed anew each millisecond, at a frequency that others set.
class Wave final : public tendon::PeriodicTask {
 public:
  explicit Wave(std::string name) : PeriodicTask(std::move(name), 1ms) {
    state_table().Add(value_, "Value");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Wave::SetFrequency, this, "SetFrequency");
    control.AddCommandReadState(state_table(), value_, "GetValue");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    phase_ += 2 * std::numbers::pi * frequency_ * period();
    value_ = std::sin(phase_);
  }
  void SetFrequency(double hertz) { frequency_ = hertz; }

  double frequency_ = 1.0;  // Hz
  double phase_ = 0.0;      // rad
  double value_ = 0.0;
};
