#include <components/teleoperation/teleoperation.h>

#include <tendon/base/error.h>
#include <tendon/payload/numeric_value.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace arm {
namespace {

constexpr std::chrono::milliseconds kPeriod{20};
constexpr double kStep = std::chrono::duration<double>(kPeriod).count();  // s

// Ten goals are sent per second; each goal replaces the previous one. An arm that follows with
// minimum-jerk motions lags behind by 0.6 times their duration. Therefore, each goal is sent ahead
// by this time.
constexpr int kCyclesPerGoal = 5;
constexpr double kDuration = 0.4;                                          // s, duration of a goal
constexpr double kAhead = 0.6 * kDuration + kCyclesPerGoal * kStep / 2.0;  // s
constexpr double kNear = 0.3;       // rad; the tour waits for an arm with a larger error
constexpr double kApproach = 2.5;   // s until the arm has joined the tour
constexpr double kSpeedUp = 1.0;    // s until the tour has its full speed
constexpr double kTurnAgain = 0.5;  // s in which further limits do not reverse the tour again

JointTour CheckedTour(const TeleoperationConfiguration& configuration, const std::string& name) {
  const auto& [period, amplitude] = configuration;
  if (!(period >= kShortestTour && period <= kLongestTour)) {
    throw tendon::ConfigurationError("configuration of '" + name + "': period is " +
                                     ToString(tendon::NumericValue(period)) +
                                     ", expected 4 to 3600 s");
  }
  if (!(amplitude >= 0.0 && amplitude <= kMaxAmplitude)) {
    throw tendon::ConfigurationError("configuration of '" + name + "': amplitude is " +
                                     ToString(tendon::NumericValue(amplitude)) +
                                     ", expected 0 to 3");
  }
  return {period, amplitude};
}

/// Returns a value that rises from 0 to 1 within `duration` s with minimum jerk, and then stays 1.
double Smooth(double time, double duration) {
  const double s = std::min(1.0, time / duration);
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

}  // namespace

Teleoperation::Teleoperation(std::string name, const Configuration& configuration)
    : PeriodicTask(std::move(name), kPeriod), tour_(CheckedTour(configuration, this->name())) {
  state_table().Add(target_, "Target");
  state_table().Add(tracking_, "Tracking");
  state_table().Add(limits_, "Limits");

  auto& robot = AddRequiredInterface("Robot");
  robot.AddFunction(move_to_, "MoveTo");
  robot.AddFunction(stop_, "Stop");
  robot.AddFunction(get_joints_, "GetJoints");
  robot.AddEventHandlerVoid(&Teleoperation::OnGoalReached, this, "GoalReached");
  robot.AddEventHandlerWrite(&Teleoperation::OnLimitExceeded, this, "LimitExceeded");
}

void Teleoperation::Run() {
  ProcessQueuedCommands();
  JointState joints;
  const tendon::Status status = get_joints_(joints);
  if (status == tendon::Status::kNotActive) is_leading_ = false;
  if (!status) return;
  if (!is_leading_) SetOut(joints);
  ContinueFrom(joints);
}

void Teleoperation::Cleanup() {
  if (is_leading_) (void)stop_();
}

void Teleoperation::SetOut(const JointState& joints) {
  is_leading_ = true;
  time_ = 0.0;
  direction_ = 1.0;
  elapsed_ = 0.0;
  turned_ = kTurnAgain;
  cycles_to_goal_ = 0;
  const JointVector begin = tour_.At(0.0);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    detour_[joint] = joints.position[joint] - begin[joint];
  }
}

void Teleoperation::ContinueFrom(const JointState& joints) {
  target_.position = PostureAt(0.0);
  tracking_.worst = 0.0;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    tracking_.error[joint] = target_.position[joint] - joints.position[joint];
    tracking_.worst = std::max(tracking_.worst, std::abs(tracking_.error[joint]));
  }
  if (--cycles_to_goal_ <= 0) SendGoal();
  turned_ += kStep;
  if (tracking_.worst > kNear) return;
  time_ += direction_ * kStep * Smooth(elapsed_, kSpeedUp);
  elapsed_ += kStep;
}

void Teleoperation::SendGoal() {
  const tendon::Status status = move_to_({.position = PostureAt(kAhead), .duration = kDuration});
  cycles_to_goal_ = kCyclesPerGoal;
  // When a suspended arm resumes, the tour starts again from the posture of the arm. Any other
  // refused goal is harmless, because the next goal follows soon.
  if (status == tendon::Status::kNotActive) is_leading_ = false;
}

JointVector Teleoperation::PostureAt(double time_ahead) const {
  const double elapsed = elapsed_ + time_ahead;
  const double pace = direction_ * Smooth(elapsed_, kSpeedUp);
  JointVector posture = tour_.At(time_ + pace * time_ahead);
  const double rest = 1.0 - Smooth(elapsed, kApproach);
  for (std::size_t joint = 0; joint < kJoints; ++joint) posture[joint] += rest * detour_[joint];
  return posture;
}

void Teleoperation::OnLimitExceeded(const LimitFault& /*fault*/) {
  ++limits_;
  if (turned_ < kTurnAgain) return;
  direction_ = -direction_;
  turned_ = 0.0;
  cycles_to_goal_ = 0;
}

}  // namespace arm
