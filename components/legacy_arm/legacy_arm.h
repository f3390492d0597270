#pragma once

#include <components/legacy_arm/legacy_payloads.h>
#include <tendon/interface/event.h>
#include <tendon/task/periodic_task.h>

#include <string>

namespace legacy {

/// An arm that looks like the others and is not: it counts in degrees and does not tell when a goal
/// is reached, so that no client of arm_interface connects to its `Control`. It moves every joint
/// at constant speed within ±120 deg, at 100 Hz.
class LegacyArm : public tendon::PeriodicTask {
 public:
  explicit LegacyArm(std::string name);

 private:
  void Run() override;
  /// It holds where it is, and waits to be told.
  void OnResume() override { Stop(); }

  void MoveTo(const JointGoal& goal);
  void Stop() { goal_ = joints_.position; }

  JointState joints_;
  JointVector goal_{};   // deg
  JointVector speed_{};  // deg/s, without sign
  tendon::WriteEvent<LimitFault> limit_exceeded_;
};

}  // namespace legacy
