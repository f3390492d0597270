#include <components/arm_supervisor/arm_supervisor.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace arm {
namespace {

constexpr std::chrono::milliseconds kPeriod{20};

/// A rough estimate of the inertia at each joint in a middle posture; kg m^2.
constexpr JointVector kInertia{1.2, 1.4, 0.7, 0.8, 0.1, 0.1, 0.02};

Activity ActivityOf(const JointState& joints) {
  Activity activity;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double speed = std::abs(joints.velocity[joint]);
    activity.speed = std::max(activity.speed, speed);
    activity.energy += 0.5 * kInertia[joint] * speed * speed;
  }
  return activity;
}

}  // namespace

ArmSupervisor::ArmSupervisor(std::string name) : PeriodicTask(std::move(name), kPeriod) {
  state_table().Add(activity_, "Activity");
  state_table().Add(flange_, "Flange");
  state_table().Add(events_, "Events");

  auto& robot = AddRequiredInterface("Robot");
  robot.AddFunction(get_joints_, "GetJoints");
  robot.AddFunction(get_link_pose_, "GetLinkPose", tendon::Need::kOptional);
  robot.AddEventHandlerVoid(&ArmSupervisor::OnGoalReached, this, "GoalReached");
  robot.AddEventHandlerWrite(&ArmSupervisor::OnLimitExceeded, this, "LimitExceeded");
}

void ArmSupervisor::Run() {
  ProcessQueuedCommands();
  JointState joints;
  activity_ = get_joints_(joints) ? ActivityOf(joints) : Activity{};
  // If the arm does not answer, `flange_` keeps its last pose.
  (void)get_link_pose_(LinkId::kFlange, flange_);
}

}  // namespace arm
