#include <components/simulated_arm/joint_path.h>

#include <algorithm>
#include <cmath>

namespace arm {
namespace {

constexpr double kShortest = 0.1;     // s; minimum duration of a motion
constexpr double kShortDecay = 0.05;  // s; minimum: a shorter decay would need too much jerk
constexpr double kLongDecay = 0.5;    // s; maximum, unless braking takes longer

/// Returns the time in s in which the velocity of `start` can decay to 0 with three quarters of the
/// acceleration limit. The maximum acceleration of the cubic is 3/2 v / t.
double Braking(const JointPoint& start, const JointLimits& limits) {
  return std::max(kShortDecay, 2.0 * std::abs(start.velocity) / limits.acceleration);
}

/// Returns the time in s in which the motion at the start decays, within a total of `duration` s.
double Decay(const JointPoint& start, double duration, const JointLimits& limits) {
  return std::min(duration, std::max(kLongDecay, Braking(start, limits)));
}

/// Returns the distance in rad that the joint moves during the decay of `decay` s.
double Coasted(const JointPoint& start, double decay) {
  return decay * (start.velocity / 2.0 + start.acceleration * decay / 12.0);
}

/// Returns the decaying motion after `time` s.
JointPoint Coast(const JointPoint& start, double decay, double time) {
  const double s = time / decay;
  const double v = start.velocity;
  const double a = start.acceleration * decay;
  const double position =
      decay * s *
      (v * (1.0 + s * s * (s / 2.0 - 1.0)) + a * s * (1.0 / 2.0 + s * (s / 4.0 - 2.0 / 3.0)));
  const double velocity = v * (1.0 + s * s * (2.0 * s - 3.0)) + a * s * (1.0 + s * (s - 2.0));
  const double acceleration = (v * 6.0 * s * (s - 1.0) + a * (1.0 + s * (3.0 * s - 4.0))) / decay;
  return {position, velocity, acceleration};
}

/// Returns the minimum-jerk motion from 0 to 1 for 0 <= s <= 1, with its derivatives with respect
/// to s.
JointPoint MinimumJerk(double s) {
  const double rest = 1.0 - s;
  return {s * s * s * (10.0 + s * (6.0 * s - 15.0)), 30.0 * s * s * rest * rest,
          60.0 * s * rest * (1.0 - 2.0 * s)};
}

}  // namespace

JointPath::JointPath(double position) : start_{position, 0.0, 0.0}, goal_(position) {}

JointPath::JointPath(const JointPoint& start, double decay)
    : start_(start), decay_(decay), goal_(start.position + Coasted(start, decay)) {}

JointPath JointPath::MoveTo(const JointPoint& start, double goal, double duration,
                            const JointLimits& limits) {
  JointPath path(start, Decay(start, duration, limits));
  path.duration_ = duration;
  path.distance_ = goal - path.goal_;
  path.goal_ = goal;
  return path;
}

JointPath JointPath::Stop(const JointPoint& start, const JointLimits& limits) {
  JointPath path(start, Braking(start, limits));
  path.duration_ = path.decay_;
  return path;
}

double JointPath::Lengthened(const JointPoint& start, double goal, double duration,
                             const JointLimits& limits) {
  // A minimum-jerk motion reaches 15/8 of its mean velocity and an acceleration of 10/sqrt(3)
  // distance/t^2. This motion gets half of the acceleration limit, and the initial motion gets the
  // other half.
  constexpr double kPeakVelocity = 15.0 / 8.0;
  const double peak_acceleration = 10.0 / std::sqrt(3.0);
  const double least = std::max({duration, kShortest, Braking(start, limits)});
  const double decay = Decay(start, least, limits);
  const double distance = std::abs(goal - start.position - Coasted(start, decay));
  return std::max({least, kPeakVelocity * distance / limits.velocity,
                   std::sqrt(peak_acceleration * distance / (0.5 * limits.acceleration))});
}

JointPoint JointPath::At(double time) const {
  if (time >= duration_) return {goal_, 0.0, 0.0};
  const double coasting = std::min(time, decay_);
  const JointPoint coast = Coast(start_, decay_, coasting);
  const JointPoint move = MinimumJerk(time / duration_);
  const bool coasts = time < decay_;
  return {start_.position + coast.position + distance_ * move.position,
          (coasts ? coast.velocity : 0.0) + distance_ * move.velocity / duration_,
          (coasts ? coast.acceleration : 0.0) +
              distance_ * move.acceleration / (duration_ * duration_)};
}

}  // namespace arm
