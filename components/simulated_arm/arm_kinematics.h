#pragma once

#include <components/arm_interface/arm_payloads.h>

namespace arm {

/// Where a link of the arm is when its joints are at `state`. Constant time, allocates nothing.
///
/// The geometry is that of a Franka Emika Panda, by its Denavit-Hartenberg parameters in Craig's
/// convention: https://frankaemika.github.io/docs/control_parameters.html
void LinkPose(const JointState& state, const LinkId& link, Pose& pose);

}  // namespace arm
