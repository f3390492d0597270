#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <components/simulated_arm/arm_configuration.h>
#include <components/simulated_arm/joint.h>
#include <components/simulated_arm/joint_path.h>

#include <array>
#include <cstddef>

namespace arm {

/// Computes the motion of a whole arm step by step, without a clock. All joints reach a goal at the
/// same time. Nothing here allocates, waits or throws.
class ArmMotion {
 public:
  /// The events in one step.
  struct StepEvents {
    bool goal_reached = false;
    std::array<bool, kJoints> limit_entered{};
  };

  /// Starts at rest at home. `configuration` must be valid; `step` in s.
  ArmMotion(const ArmConfiguration& configuration, double step);

  /// Moves to the goal and comes to rest there, in the goal's duration, or longer if the limits
  /// require it. If the goal is beyond the limits, the joint stops at the end of its range. Returns
  /// false, and changes nothing, if a number in the goal is not finite or absurdly large.
  bool MoveTo(const JointGoal& goal);
  /// Moves at these velocities, in rad/s, until the next command; a joint stops at the end of its
  /// range. Abandons the goal. Returns false, and changes nothing, if a number is not finite.
  bool MoveAt(const JointVector& velocity);
  /// Stops as quickly as the limits allow. Abandons the goal.
  void Stop();
  /// Stops at once at the present position.
  void Rest();

  StepEvents Step();

  [[nodiscard]] JointState state() const;
  /// Returns the present goal with the total duration of its motion. While the arm moves at a
  /// velocity, returns the present position with duration 0.
  [[nodiscard]] JointGoal goal() const;
  /// True while the arm moves at a velocity.
  [[nodiscard]] bool is_cruising() const { return is_cruising_; }
  /// True while a goal is not yet reached or the arm moves at a velocity.
  [[nodiscard]] bool is_under_way() const { return has_goal_ || is_cruising_; }

 private:
  [[nodiscard]] bool HasArrived() const;
  JointPoint ReferenceOf(std::size_t joint);

  double step_;
  std::array<Joint, kJoints> joints_;
  std::array<JointPath, kJoints> paths_;
  double duration_ = 0.0;  // s, duration of the longest path
  double elapsed_ = 0.0;   // s since the paths began
  bool has_goal_ = false;  // true while a goal is not yet reached
  bool is_cruising_ = false;
  JointVector wanted_{};  // rad/s, the target velocity while cruising
  JointVector cruise_{};  // rad/s, the present velocity on the way to `wanted_`
};

}  // namespace arm
