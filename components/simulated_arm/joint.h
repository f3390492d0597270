#pragma once

#include <components/simulated_arm/joint_path.h>

namespace arm {

/// The mechanics of one joint: it follows a reference as a critically damped system of second
/// order, and keeps its limits for any reference.
///
/// After every step
///  1. |velocity| and |acceleration| are within the limits,
///  2. the position is between lower and upper,
///  3. velocity^2 <= 2 * acceleration limit * distance to the end ahead: full braking stops the
///     joint in time, so that 2. also holds after the next step.
class Joint {
 public:
  /// Starts at rest at `position`, which must be within the limits. `bandwidth` in rad/s.
  Joint(const JointLimits& limits, double bandwidth, double position);

  /// Advances the joint by `step` s; `reference` is the desired motion at the beginning of the
  /// step.
  void Step(const JointPoint& reference, double step);
  /// Stops at once at the present position.
  void Rest();

  [[nodiscard]] const JointPoint& point() const { return point_; }
  [[nodiscard]] const JointLimits& limits() const { return limits_; }
  /// True if the last step reached an end of the range. Becomes true again only after the joint has
  /// left this end.
  [[nodiscard]] bool has_entered_limit() const { return has_entered_limit_; }

 private:
  void WatchLimits();

  JointLimits limits_;
  double bandwidth_;
  JointPoint point_;
  bool is_at_limit_ = true;  // an arm that starts at the end of its range raises no event
  bool has_entered_limit_ = false;
};

}  // namespace arm
