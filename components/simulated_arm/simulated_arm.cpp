#include <components/simulated_arm/simulated_arm.h>

#include <components/simulated_arm/arm_kinematics.h>
#include <tendon/base/log.h>

#include <chrono>
#include <utility>

namespace arm {
namespace {

constexpr std::chrono::milliseconds kPeriod{1};
constexpr std::chrono::milliseconds kRenewal{100};

const ArmConfiguration& Checked(const ArmConfiguration& configuration, const std::string& name) {
  RequireValid(configuration, name);
  return configuration;
}

}  // namespace

SimulatedArm::SimulatedArm(std::string name, const Configuration& configuration)
    : PeriodicTask(std::move(name), kPeriod),
      motion_(Checked(configuration, this->name()), std::chrono::duration<double>(kPeriod).count()),
      noise_(configuration.noise) {
  state_table().Add(joints_, "Joints");
  state_table().Add(goal_, "Goal");
  state_table().Add(refused_, "Refused");

  auto& control = AddProvidedInterface("Control");
  control.AddCommandVoid(&SimulatedArm::Stop, this, "Stop");
  control.AddCommandWrite(&SimulatedArm::MoveTo, this, "MoveTo").SetHazard("motion");
  control.AddCommandWrite(&SimulatedArm::MoveAt, this, "MoveAt")
      .SetHazard("motion")
      .ExpiresAfter(kRenewal, &SimulatedArm::EndMoveAt, this);
  control.AddCommandReadState(state_table(), joints_, "GetJoints");
  control.AddCommandQualifiedRead(state_table(), joints_, &LinkPose, "GetLinkPose");
  control.AddEvent(limit_exceeded_, "LimitExceeded");
  control.AddEvent(goal_reached_, "GoalReached");
}

void SimulatedArm::Startup() { motion_.Rest(); }

void SimulatedArm::Run() {
  ProcessQueuedCommands();
  const ArmMotion::StepEvents events = motion_.Step();
  Measure();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    if (!events.limit_entered[joint]) continue;
    limit_exceeded_({static_cast<std::int32_t>(joint), joints_.position[joint]});
  }
  if (events.goal_reached) goal_reached_();
}

void SimulatedArm::OnResume() {
  if (motion_.is_under_way()) {
    Log(tendon::LogLevel::kWarning, name(),
        "holds its position, because the arm was suspended during a motion; it moves again after "
        "the next command");
  }
  motion_.Rest();
}

void SimulatedArm::MoveTo(const JointGoal& goal) {
  if (!motion_.MoveTo(goal)) ++refused_;
}

void SimulatedArm::MoveAt(const JointVelocity& velocity) {
  if (motion_.MoveAt(velocity.velocity)) return;
  ++refused_;
  EndMoveAt();  // the refused call has renewed the time limit of the last accepted call
}

void SimulatedArm::EndMoveAt() {
  if (motion_.is_cruising()) motion_.Stop();
}

void SimulatedArm::Measure() {
  joints_ = motion_.state();
  goal_ = motion_.goal();
  if (noise_ == 0.0) return;
  for (double& position : joints_.position) position += noise_ * normal_(random_);
}

}  // namespace arm
