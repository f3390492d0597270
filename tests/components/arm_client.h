#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <tendon/interface/function.h>
#include <tendon/task/component.h>

#include <string>
#include <vector>

namespace tendon_test {

/// A client without a thread that needs every member of an arm's `Control`. Its handlers run in the
/// thread that raises the events. Used for arms that the test steps itself.
class ArmClient : public tendon::Component {
 public:
  explicit ArmClient(std::string name) : Component(std::move(name)) {
    auto& robot = AddRequiredInterface("Robot");
    robot.AddFunction(stop, "Stop");
    robot.AddFunction(move_to, "MoveTo");
    robot.AddFunction(move_at, "MoveAt", tendon::Need::kOptional);
    robot.AddFunction(get_joints, "GetJoints");
    robot.AddFunction(get_link_pose, "GetLinkPose");
    robot.AddEventHandlerWrite(&ArmClient::OnLimitExceeded, this, "LimitExceeded");
    robot.AddEventHandlerVoid(&ArmClient::OnGoalReached, this, "GoalReached");
    faults.reserve(64);
  }

  tendon::VoidFunction stop;
  tendon::WriteFunction<arm::JointGoal> move_to;
  tendon::WriteFunction<arm::JointVelocity> move_at;
  tendon::ReadFunction<arm::JointState> get_joints;
  tendon::QualifiedReadFunction<arm::LinkId, arm::Pose> get_link_pose;

  std::vector<arm::LimitFault> faults;
  int goals_reached = 0;

 private:
  void OnLimitExceeded(const arm::LimitFault& fault) { faults.push_back(fault); }
  void OnGoalReached() { ++goals_reached; }
};

}  // namespace tendon_test
