#include <components/teleoperation/joint_tour.h>

#include <cmath>
#include <numbers>

namespace arm {

JointTour::JointTour(double period, double amplitude)
    : rate_(2.0 * std::numbers::pi / period), amplitude_(amplitude) {}

JointVector JointTour::At(double time) const {
  constexpr JointVector kMiddle{0.0, -0.35, 0.0, -1.75, 0.0, 1.6, 0.785};
  constexpr double kSteepness = 2.5;  // steepness of the edges of joint 3
  const double angle = rate_ * time;
  const double edges = std::tanh(kSteepness * std::sin(angle - 0.6)) / std::tanh(kSteepness);
  const JointVector swing{
      1.1 * std::sin(angle),                                       // a plain wave
      0.5 * std::sin(angle + 1.9) + 0.13 * std::sin(4.0 * angle),  // a wave with ripples
      0.35 * std::sin(4.0 / 3.0 * angle),
      0.55 * edges,  // two plateaus
      0.45 * std::sin(2.0 / 3.0 * angle),
      0.35 * std::cos(angle),
      0.6 * std::sin(5.0 / 3.0 * angle),
  };
  JointVector posture = kMiddle;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    posture[joint] += amplitude_ * swing[joint];
  }
  return posture;
}

}  // namespace arm
