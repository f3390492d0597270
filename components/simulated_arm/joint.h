#pragma once

#include <components/simulated_arm/joint_path.h>

namespace arm {

/// The mechanics of one joint: it follows a reference as a critically damped system of second
/// order, and keeps its limits whatever the reference does.
///
/// After every step
///  1. |velocity| and |acceleration| are within the limits,
///  2. the position is between lower and upper,
///  3. velocity^2 <= 2 * acceleration limit * distance to the end it moves to: full brakes stop it
///     in time, so 2 holds after the next step as well.
class Joint {
 public:
  /// At rest at `position`, which is within the limits. `bandwidth` in rad/s.
  Joint(const JointLimits& limits, double bandwidth, double position);

  /// Goes on by `step` s; `reference` is where it should be at the beginning of the step.
  void Step(const JointPoint& reference, double step);
  /// At rest where it is, at once.
  void Rest();

  [[nodiscard]] const JointPoint& point() const { return point_; }
  [[nodiscard]] const JointLimits& limits() const { return limits_; }
  /// Whether the last step took it to an end of its range. Once, until it has moved away again.
  [[nodiscard]] bool has_entered_limit() const { return has_entered_limit_; }

 private:
  void WatchLimits();

  JointLimits limits_;
  double bandwidth_;
  JointPoint point_;
  bool is_at_limit_ = true;  // an arm may begin at the end of its range: that is no event
  bool has_entered_limit_ = false;
};

}  // namespace arm
