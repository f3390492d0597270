#pragma once

#include <tendon/payload/robot/header.h>

#include <cstdint>
#include <vector>

namespace tendon::robot {

/// Sticks, pedals and buttons that a person moves, as many as the device has.
struct Joystick {
  Header header;
  std::vector<float> axes;            ///< -1 to 1; 0 where it is let go
  std::vector<std::int32_t> buttons;  ///< 1 while pressed, else 0

  bool operator==(const Joystick&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::Joystick> = Describe(
    "sensor_msgs.Joy", Field{"header", &robot::Joystick::header},
    Field{"axes", &robot::Joystick::axes}.Within(-1, 1).Help("0 where it is let go."),
    Field{"buttons", &robot::Joystick::buttons}.Within(0, 1).Help("1 while it is pressed."));

}  // namespace tendon
