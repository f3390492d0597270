#pragma once

#include <components/arm_interface/arm_payloads.h>

namespace arm {

/// A closed curve through the postures of an arm, after Lissajous: every joint swings in its own
/// rhythm, none comes near the limits of a Panda while `amplitude` is at most 1.
class Tour {
 public:
  /// `period` in s: after it joints 0, 1, 3 and 5 are where they were, after three of it all are.
  /// `amplitude` scales how far the joints swing.
  Tour(double period, double amplitude);

  /// The posture at a time in s, which may be negative; rad.
  [[nodiscard]] JointVector At(double time) const;

 private:
  double rate_;  // rad/s
  double amplitude_;
};

}  // namespace arm
