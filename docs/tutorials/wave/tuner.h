#pragma once

#include <tendon/task/periodic_task.h>

#include <string>
#include <utility>

using namespace std::chrono_literals;

/// Makes a wave faster and faster, then slow again.
class Tuner final : public tendon::PeriodicTask {
 public:
  explicit Tuner(std::string name) : PeriodicTask(std::move(name), 100ms) {
    auto& wave = AddRequiredInterface("Wave");
    wave.AddFunction(set_frequency_, "SetFrequency");
    wave.AddFunction(get_value_, "GetValue");
    state_table().Add(frequency_, "Frequency");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    double value = 0.0;
    if (!get_value_(value)) return;  // not connected, or no sample yet: try again next cycle
    frequency_ = frequency_ < 5.0 ? frequency_ + 0.1 : 0.5;
    if (!set_frequency_(frequency_)) ++refused_;
  }

  tendon::WriteFunction<double> set_frequency_;
  tendon::ReadFunction<double> get_value_;
  double frequency_ = 0.5;  // Hz
  int refused_ = 0;
};
