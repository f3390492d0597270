#include <components/simulated_arm/arm_kinematics.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace arm {
namespace {

using Vector = std::array<double, 3>;      // m
using Quaternion = std::array<double, 4>;  // x, y, z, w

/// From one frame to the next: turn by `twist` about x, go `length` along it, turn by the joint's
/// angle about z, go `offset` along it.
struct DenavitHartenberg {
  double length;  // a, m
  double offset;  // d, m
  double twist;   // alpha, rad
};

constexpr double kQuarter = std::numbers::pi / 2;
constexpr std::array<DenavitHartenberg, kJoints + 1> kChain{{
    {0.0, 0.333, 0.0},
    {0.0, 0.0, -kQuarter},
    {0.0, 0.316, kQuarter},
    {0.0825, 0.0, kQuarter},
    {-0.0825, 0.384, -kQuarter},
    {0.0, 0.0, kQuarter},
    {0.088, 0.0, kQuarter},
    {0.0, 0.107, 0.0},  // the flange, which no joint turns
}};

Quaternion Product(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

Vector Rotated(const Quaternion& q, const Vector& v) {
  const Quaternion conjugate{-q[0], -q[1], -q[2], q[3]};
  const Quaternion turned = Product(Product(q, {v[0], v[1], v[2], 0.0}), conjugate);
  return {turned[0], turned[1], turned[2]};
}

void Shift(Pose& pose, const Vector& by) {
  const Vector turned = Rotated(pose.orientation, by);
  for (std::size_t i = 0; i < turned.size(); ++i) pose.position[i] += turned[i];
}

void GoOn(Pose& pose, const DenavitHartenberg& to, double angle) {
  const Quaternion about_x{std::sin(to.twist / 2), 0.0, 0.0, std::cos(to.twist / 2)};
  const Quaternion about_z{0.0, 0.0, std::sin(angle / 2), std::cos(angle / 2)};
  pose.orientation = Product(pose.orientation, about_x);
  Shift(pose, {to.length, 0.0, 0.0});
  pose.orientation = Product(pose.orientation, about_z);
  Shift(pose, {0.0, 0.0, to.offset});
}

}  // namespace

void LinkPose(const JointState& state, const LinkId& link, Pose& pose) {
  pose = Pose{};
  const auto frames = std::min(static_cast<std::size_t>(link), kChain.size());
  for (std::size_t frame = 0; frame < frames; ++frame) {
    GoOn(pose, kChain[frame], frame < kJoints ? state.position[frame] : 0.0);
  }
}

}  // namespace arm
