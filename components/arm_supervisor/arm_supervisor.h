#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <components/arm_supervisor/supervisor_payloads.h>
#include <tendon/interface/function.h>
#include <tendon/task/periodic_task.h>

#include <string>

namespace arm {

/// Watches an arm at 50 Hz and never moves it. Reads the joints and, if the arm offers it, the pose
/// of the flange. Counts the arm's events. Records `Activity`, `Flange` and `Events`.
class ArmSupervisor : public tendon::PeriodicTask {
 public:
  explicit ArmSupervisor(std::string name);

 private:
  void Startup() override { events_ = {}; }
  void Run() override;
  /// The peer may be another arm, so the last flange pose is outdated.
  void OnConnected(tendon::RequiredInterface& /*robot*/) override { flange_ = {}; }

  void OnGoalReached() { ++events_.goals; }
  void OnLimitExceeded(const LimitFault& /*fault*/) { ++events_.limits; }

  tendon::ReadFunction<JointState> get_joints_;
  tendon::QualifiedReadFunction<LinkId, Pose> get_link_pose_;

  Activity activity_;
  Pose flange_;
  EventCounts events_;
};

}  // namespace arm
