#pragma once

#include <tendon/payload/payload.h>
#include <tendon/payload/time_point.h>

#include <chrono>
#include <string>

namespace tendon::robot {

/// The time of a measurement and the frame of its coordinates. Rows of a state table and events
/// already have a time; a header is for measurements taken at a different time.
struct Header {
  std::chrono::sys_time<std::chrono::nanoseconds> stamp{};
  std::string frame_id{};

  bool operator==(const Header&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::Header> = Describe(
    "std_msgs.Header", Field{"stamp", &robot::Header::stamp}.Help("Time of the measurement."),
    Field{"frame_id", &robot::Header::frame_id}.Help("The frame of all coordinates."));

}  // namespace tendon
