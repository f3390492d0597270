#include <components/simulated_arm/arm_motion.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace arm {
namespace {

// rad for the position, rad/s for the velocity: closer to the goal than this counts as there.
constexpr double kArrived = 1e-3;
constexpr double kFurthest = 1e3;    // rad
constexpr double kLongest = 3600.0;  // s
constexpr double kGentle = 0.25;     // fraction of the acceleration limit for changes of velocity

template <std::size_t... kIndex>
std::array<Joint, kJoints> MakeJoints(const ArmConfiguration& configuration,
                                      std::index_sequence<kIndex...> /*joints*/) {
  const auto make = [&configuration](std::size_t joint) {
    const JointLimits limits{configuration.lower[joint], configuration.upper[joint],
                             configuration.velocity[joint], configuration.acceleration[joint]};
    return Joint(limits, configuration.bandwidth, configuration.home[joint]);
  };
  return {make(kIndex)...};
}

/// True if all numbers of a goal are in their ranges. False for NaN.
bool IsSensible(const JointGoal& goal) {
  return std::all_of(goal.position.begin(), goal.position.end(),
                     [](double position) { return std::abs(position) <= kFurthest; }) &&
         goal.duration >= 0.0 && goal.duration <= kLongest;
}

}  // namespace

ArmMotion::ArmMotion(const ArmConfiguration& configuration, double step)
    : step_(step), joints_(MakeJoints(configuration, std::make_index_sequence<kJoints>())) {
  Rest();
}

bool ArmMotion::MoveTo(const JointGoal& goal) {
  if (!IsSensible(goal)) return false;
  duration_ = goal.duration;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    duration_ =
        std::max(duration_, JointPath::Lengthened(joints_[joint].point(), goal.position[joint],
                                                  goal.duration, joints_[joint].limits()));
  }
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    paths_[joint] = JointPath::MoveTo(joints_[joint].point(), goal.position[joint], duration_,
                                      joints_[joint].limits());
  }
  elapsed_ = 0.0;
  has_goal_ = true;
  is_cruising_ = false;
  return true;
}

bool ArmMotion::MoveAt(const JointVector& velocity) {
  if (!std::ranges::all_of(velocity, [](double one) { return std::isfinite(one); })) return false;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double fastest = joints_[joint].limits().velocity;
    wanted_[joint] = std::clamp(velocity[joint], -fastest, fastest);
    if (!is_cruising_) cruise_[joint] = joints_[joint].point().velocity;
  }
  is_cruising_ = true;
  has_goal_ = false;
  return true;
}

void ArmMotion::Stop() {
  duration_ = 0.0;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    paths_[joint] = JointPath::Stop(joints_[joint].point(), joints_[joint].limits());
    duration_ = std::max(duration_, paths_[joint].duration());
  }
  elapsed_ = 0.0;
  has_goal_ = false;
  is_cruising_ = false;
}

void ArmMotion::Rest() {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    joints_[joint].Rest();
    paths_[joint] = JointPath(joints_[joint].point().position);
  }
  duration_ = 0.0;
  elapsed_ = 0.0;
  has_goal_ = false;
  is_cruising_ = false;
}

ArmMotion::StepEvents ArmMotion::Step() {
  StepEvents events;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    joints_[joint].Step(ReferenceOf(joint), step_);
    events.limit_entered[joint] = joints_[joint].has_entered_limit();
  }
  elapsed_ = std::min(elapsed_ + step_, duration_);
  events.goal_reached = has_goal_ && HasArrived();
  if (events.goal_reached) has_goal_ = false;
  return events;
}

JointPoint ArmMotion::ReferenceOf(std::size_t joint) {
  if (!is_cruising_) return paths_[joint].At(elapsed_);
  const double most = kGentle * joints_[joint].limits().acceleration * step_;
  const double change = std::clamp(wanted_[joint] - cruise_[joint], -most, most);
  cruise_[joint] += change;
  return {joints_[joint].point().position, cruise_[joint], change / step_};
}

JointState ArmMotion::state() const {
  JointState state;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    state.position[joint] = joints_[joint].point().position;
    state.velocity[joint] = joints_[joint].point().velocity;
  }
  return state;
}

JointGoal ArmMotion::goal() const {
  if (is_cruising_) return {.position = state().position, .duration = 0.0};
  JointGoal goal{.position = {}, .duration = duration_};
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    goal.position[joint] = paths_[joint].goal();
  }
  return goal;
}

bool ArmMotion::HasArrived() const {
  if (elapsed_ < duration_) return false;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const JointPoint& point = joints_[joint].point();
    const bool is_near = std::abs(point.position - paths_[joint].goal()) <= kArrived;
    if (!is_near || std::abs(point.velocity) > kArrived) return false;
  }
  return true;
}

}  // namespace arm
