#pragma once

namespace arm {

/// What one joint may do.
struct JointLimits {
  double lower = 0.0;         ///< rad
  double upper = 0.0;         ///< rad
  double velocity = 0.0;      ///< greatest, rad/s
  double acceleration = 0.0;  ///< greatest, rad/s^2
};

/// One joint at one time.
struct JointPoint {
  double position = 0.0;      ///< rad
  double velocity = 0.0;      ///< rad/s
  double acceleration = 0.0;  ///< rad/s^2
};

/// A smooth way of one joint from where it is, however it moves, to rest.
///
/// The sum of two motions: what the joint has at the start dies away (a cubic velocity), and a
/// minimum-jerk motion (Flash and Hogan, 1985) makes up the distance that remains. Position,
/// velocity and acceleration are continuous from the start on. In short motions both parts take the
/// same time and the sum is the quintic of those boundary values; in long ones the first part ends
/// early, so that a joint in motion does not swing out because it was given much time.
class JointPath {
 public:
  /// Rests.
  explicit JointPath(double position = 0.0);
  /// At rest at `goal` after `duration` s.
  static JointPath MoveTo(const JointPoint& start, double goal, double duration,
                          const JointLimits& limits);
  /// At rest as soon as the limits allow.
  static JointPath Stop(const JointPoint& start, const JointLimits& limits);

  /// s: what MoveTo() needs in order to keep velocity and acceleration well within the limits,
  /// when `duration` is wanted; not less than that.
  static double Lengthened(const JointPoint& start, double goal, double duration,
                           const JointLimits& limits);

  /// `time` is s since the start; at the goal from duration() on.
  [[nodiscard]] JointPoint At(double time) const;
  [[nodiscard]] double duration() const { return duration_; }
  [[nodiscard]] double goal() const { return goal_; }

 private:
  JointPath(const JointPoint& start, double decay);

  JointPoint start_;
  double decay_ = 0.0;     // s that the motion at the start takes to die away
  double distance_ = 0.0;  // rad that are left for the minimum-jerk motion
  double duration_ = 0.0;
  double goal_;
};

}  // namespace arm
