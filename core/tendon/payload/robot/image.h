#pragma once

#include <tendon/payload/robot/header.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tendon::robot {

/// One uncompressed image. The rows are stored from top to bottom, and the pixels of a row from
/// left to right. An image from another program may be incomplete: check that `data` has `height`
/// times `step` bytes.
struct Image {
  Header header{};  ///< axes of its frame: z points out of the camera, x right, y down
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding{};         ///< "rgb8", "bgr8", "mono8", "mono16", "16UC1", "32FC1", ...
  std::uint8_t is_bigendian = 0;  ///< 1: the highest byte of a pixel comes first
  std::uint32_t step = 0;         ///< bytes of a row, including padding
  std::vector<std::uint8_t> data{};

  bool operator==(const Image&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::Image> = Describe(
    "sensor_msgs.Image", Field{"header", &robot::Image::header},
    Field{"height", &robot::Image::height}.Help("Number of rows."),
    Field{"width", &robot::Image::width}.Help("Number of pixels in a row."),
    Field{"encoding", &robot::Image::encoding}.Help(
        "Format of a pixel, as in ROS: rgb8, bgr8, mono8, mono16, 16UC1, 32FC1, ..."),
    Field{"is_bigendian", &robot::Image::is_bigendian}.Within(0, 1).Help(
        "1 if the bytes of a pixel are big-endian."),
    Field{"step", &robot::Image::step}.Help("Number of bytes in a row, including padding."),
    Field{"data", &robot::Image::data}.Help(
        "All rows, from top to bottom: height times step bytes."));

}  // namespace tendon
