#pragma once

#include <components/arm_interface/arm_payloads.h>

namespace arm {

/// Computes the pose of `link` for the joints in `state`. Constant time, allocates nothing.
///
/// The robot is a Franka Emika Panda, described by its Denavit-Hartenberg parameters in Craig's
/// convention: https://frankaemika.github.io/docs/control_parameters.html
void LinkPose(const JointState& state, const LinkId& link, Pose& pose);

}  // namespace arm
