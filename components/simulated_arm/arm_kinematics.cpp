#include <components/simulated_arm/arm_kinematics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace arm {
namespace {

using tendon::robot::Quaternion;
using tendon::robot::Vector3;

/// The step from one frame to the next: rotate by `twist` about x, move by `length` along x, rotate
/// by the joint angle about z, move by `offset` along z.
struct DenavitHartenberg {
  double length;  // m, the parameter a
  double offset;  // m, the parameter d
  double twist;   // rad, the parameter alpha
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
    {0.0, 0.107, 0.0},  // the flange, which has no joint
}};

Quaternion Product(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// Moves a frame by `by`, in m, in the frame's own coordinates.
void Shift(Pose& pose, const Vector3& by) {
  const Quaternion& q = pose.orientation;
  const Quaternion conjugate{-q.x, -q.y, -q.z, q.w};
  const Quaternion turned = Product(Product(q, {by.x, by.y, by.z, 0.0}), conjugate);
  pose.position.x += turned.x;
  pose.position.y += turned.y;
  pose.position.z += turned.z;
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
