#pragma once

#include <tendon/payload/robot/geometry.h>
#include <tendon/payload/robot/header.h>

#include <string>
#include <vector>

namespace tendon::robot {

/// The frame `child_frame_id`, seen from `header.frame_id`: maps coordinates in the child to
/// coordinates in its parent.
struct TransformStamped {
  Header header;
  std::string child_frame_id;
  Transform transform;

  bool operator==(const TransformStamped&) const = default;
};

/// Some frames of a robot, in any order; with those sent before, they form a tree.
struct Transforms {
  std::vector<TransformStamped> transforms;

  bool operator==(const Transforms&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::TransformStamped> =
    Describe("geometry_msgs.TransformStamped", Field{"header", &robot::TransformStamped::header},
             Field{"child_frame_id", &robot::TransformStamped::child_frame_id},
             Field{"transform", &robot::TransformStamped::transform}.Help(
                 "From the child to header.frame_id."));

template <>
inline constexpr auto kPayload<robot::Transforms> =
    Describe("tf2_msgs.TFMessage", Field{"transforms", &robot::Transforms::transforms});

}  // namespace tendon
