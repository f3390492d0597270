#include <components/legacy_arm/legacy_arm.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace legacy {
namespace {

constexpr std::chrono::milliseconds kPeriod{10};
constexpr double kStep = std::chrono::duration<double>(kPeriod).count();  // s
constexpr double kLimit = 120.0;                                          // deg, in both directions
constexpr double kFastest = 60.0;                                         // deg/s

}  // namespace

LegacyArm::LegacyArm(std::string name) : PeriodicTask(std::move(name), kPeriod) {
  state_table().Add(joints_, "Joints");

  auto& control = AddProvidedInterface("Control");
  control.AddCommandVoid(&LegacyArm::Stop, this, "Stop");
  control.AddCommandWrite(&LegacyArm::MoveTo, this, "MoveTo").SetHazard("motion");
  control.AddCommandReadState(state_table(), joints_, "GetJoints");
  control.AddEvent(limit_exceeded_, "LimitExceeded");
}

void LegacyArm::Run() {
  ProcessQueuedCommands();
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    double& position = joints_.position[joint];
    const double before = position;
    const double longest = speed_[joint] * kStep;
    position += std::clamp(goal_[joint] - position, -longest, longest);
    joints_.velocity[joint] = (position - before) / kStep;
  }
}

void LegacyArm::MoveTo(const JointGoal& goal) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double wanted = goal.position[joint];
    if (!std::isfinite(wanted)) continue;
    goal_[joint] = std::clamp(wanted, -kLimit, kLimit);
    if (goal_[joint] != wanted) limit_exceeded_({static_cast<std::int32_t>(joint), wanted});
    const double distance = std::abs(goal_[joint] - joints_.position[joint]);
    // With this form of the condition, a duration of 0 or NaN gives the highest speed.
    speed_[joint] = goal.duration > distance / kFastest ? distance / goal.duration : kFastest;
  }
}

}  // namespace legacy
