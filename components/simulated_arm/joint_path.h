#pragma once

namespace arm {

/// The limits of one joint.
struct JointLimits {
  double lower = 0.0;         ///< rad
  double upper = 0.0;         ///< rad
  double velocity = 0.0;      ///< maximum, rad/s
  double acceleration = 0.0;  ///< maximum, rad/s^2
};

/// The motion of one joint at one time.
struct JointPoint {
  double position = 0.0;      ///< rad
  double velocity = 0.0;      ///< rad/s
  double acceleration = 0.0;  ///< rad/s^2
};

/// A smooth path of one joint from its present motion to rest.
///
/// The path is the sum of two motions. In the first one, the motion at the start decays (a cubic
/// velocity). The second one is a minimum-jerk motion (Flash and Hogan, 1985) over the remaining
/// distance. Position, velocity and acceleration are continuous. In a short path, both parts take
/// the same time; their sum is then the quintic polynomial with these boundary values. In a long
/// path, the first part ends early, so that a moving joint does not overshoot.
class JointPath {
 public:
  /// Makes the path of a joint that is at rest at `position`.
  explicit JointPath(double position = 0.0);
  /// Makes a path that comes to rest at `goal` after `duration` s.
  static JointPath MoveTo(const JointPoint& start, double goal, double duration,
                          const JointLimits& limits);
  /// Makes a path that comes to rest as soon as the limits allow.
  static JointPath Stop(const JointPoint& start, const JointLimits& limits);

  /// Returns the duration in s, at least `duration`, with which MoveTo() keeps velocity and
  /// acceleration well within the limits.
  static double Lengthened(const JointPoint& start, double goal, double duration,
                           const JointLimits& limits);

  /// Returns the motion at `time`, in s since the start. From duration() on, the joint is at the
  /// goal.
  [[nodiscard]] JointPoint At(double time) const;
  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] double goal() const { return goal_; }

 private:
  JointPath(const JointPoint& start, double decay);

  JointPoint start_;
  double decay_ = 0.0;     // s until the motion at the start has decayed
  double distance_ = 0.0;  // rad covered by the minimum-jerk motion
  double duration_ = 0.0;
  double goal_;
};

}  // namespace arm
