#pragma once

#include <components/arm_interface/arm_payloads.h>

namespace arm {

/// A closed curve through the postures of an arm (a Lissajous curve). Every joint swings with its
/// own period; no joint comes near the limits of a Panda while `amplitude` is at most 1.
class JointTour {
 public:
  /// `period` in s: joints 0, 1, 3 and 5 return after one period, all joints after three.
  /// `amplitude` scales how far the joints swing.
  JointTour(double period, double amplitude);

  /// Returns the posture in rad at a time in s, which may be negative.
  [[nodiscard]] JointVector At(double time) const;

 private:
  double rate_;  // rad/s
  double amplitude_;
};

}  // namespace arm
