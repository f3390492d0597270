#pragma once

#include <tendon/payload/robot/geometry.h>
#include <tendon/payload/robot/header.h>

#include <string>
#include <vector>

namespace tendon::robot {

/// The position and orientation of the frame `child_frame_id` in its parent frame,
/// `header.frame_id`. `transform` maps coordinates in the child frame to coordinates in the parent
/// frame.
struct TransformStamped {
  Header header{};
  std::string child_frame_id{};
  Transform transform{};

  bool operator==(const TransformStamped&) const = default;
};

/// Some frames of a robot, in any order. Together with the frames that were sent before, they form
/// a tree.
struct Transforms {
  std::vector<TransformStamped> transforms{};

  bool operator==(const Transforms&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::TransformStamped> =
    Describe("geometry_msgs.TransformStamped", Field{"header", &robot::TransformStamped::header},
             Field{"child_frame_id", &robot::TransformStamped::child_frame_id},
             Field{"transform", &robot::TransformStamped::transform}.Help(
                 "Maps coordinates in the child frame to header.frame_id."));

template <>
inline constexpr auto kPayload<robot::Transforms> =
    Describe("tf2_msgs.TFMessage", Field{"transforms", &robot::Transforms::transforms});

}  // namespace tendon
