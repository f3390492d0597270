#pragma once

#include <components/legacy_arm/legacy_payloads.h>
#include <tendon/interface/event.h>
#include <tendon/task/periodic_task.h>

#include <string>

namespace legacy {

/// An arm whose interface has the usual names but other types: it uses degrees and has no event for
/// a reached goal. Therefore, no client of arm_interface can connect to its `Control`. It moves
/// every joint at constant speed within ±120 deg, at 100 Hz.
class LegacyArm : public tendon::PeriodicTask {
 public:
  explicit LegacyArm(std::string name);

 private:
  void Run() override;
  /// Holds its position until the next command.
  void OnResume() override { Stop(); }

  void MoveTo(const JointGoal& goal);
  void Stop() { goal_ = joints_.position; }

  JointState joints_;
  JointVector goal_{};   // deg
  JointVector speed_{};  // deg/s, absolute
  tendon::WriteEvent<LimitFault> limit_exceeded_;
};

}  // namespace legacy
