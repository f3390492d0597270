#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <components/simulated_arm/arm_configuration.h>
#include <components/simulated_arm/joint.h>
#include <components/simulated_arm/joint_path.h>

#include <array>

namespace arm {

/// The motion of a whole arm, step by step: pure arithmetic, without a clock. All joints of a goal
/// arrive at the same time. Nothing here allocates, waits or throws.
class ArmMotion {
 public:
  /// What a step brought about.
  struct Happenings {
    bool goal_reached = false;
    std::array<bool, kJoints> limit_entered{};
  };

  /// At rest at home. `configuration` is valid; `step` in s.
  ArmMotion(const ArmConfiguration& configuration, double step);

  /// From the present motion to rest at the goal, in its duration or in what the limits ask for.
  /// A goal beyond the limits is tried: the joint stops at the end of its range. False, and nothing
  /// changes, when a number in the goal is not finite or absurd.
  bool MoveTo(const JointGoal& goal);
  /// At these velocities, rad/s, until it is told otherwise; a joint stops at the end of its range.
  /// The goal is given up. False, and nothing changes, when a number is not finite.
  bool MoveAt(const JointVector& velocity);
  /// To rest, as quickly as the limits allow. The goal is given up.
  void Stop();
  /// At rest where it is, at once.
  void Rest();

  Happenings Step();

  [[nodiscard]] JointState state() const;
  /// Where it is going, and the time that this takes in all; where it is, in no time, as long as it
  /// moves at a velocity.
  [[nodiscard]] JointGoal goal() const;
  /// Whether it moves at a velocity.
  [[nodiscard]] bool is_cruising() const { return is_cruising_; }
  /// Whether it has still to reach a goal, or moves at a velocity.
  [[nodiscard]] bool is_under_way() const { return has_goal_ || is_cruising_; }

 private:
  [[nodiscard]] bool HasArrived() const;
  JointPoint ReferenceOf(std::size_t joint);

  double step_;
  std::array<Joint, kJoints> joints_;
  std::array<JointPath, kJoints> paths_;
  double duration_ = 0.0;  // s, of the longest path
  double elapsed_ = 0.0;   // s since the paths began
  bool has_goal_ = false;  // that is not yet reached
  bool is_cruising_ = false;
  JointVector wanted_{};  // rad/s, while it cruises
  JointVector cruise_{};  // rad/s, on the way there
};

}  // namespace arm
