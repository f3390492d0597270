#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <tendon/interface/function.h>
#include <tendon/task/periodic_task.h>

#include <chrono>
#include <string>
#include <utility>

namespace faults {

/// Turns the first joint of an arm, and never stops it.
class Jogger final : public tendon::PeriodicTask {
 public:
  static constexpr double kVelocity = 0.4;  // rad/s

  explicit Jogger(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(20)) {
    AddRequiredInterface("Robot").AddFunction(move_at_, "MoveAt");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    (void)move_at_({.velocity = {kVelocity}});
  }

  tendon::WriteFunction<arm::JointVelocity> move_at_;
};

}  // namespace faults
