#pragma once

#include <tendon/payload/robot/header.h>

#include <cstdint>
#include <vector>

namespace tendon::robot {

/// The sticks, pedals and buttons of an input device, as many as it has.
struct Joystick {
  Header header{};
  std::vector<float> axes{};            ///< -1 to 1; 0 when released
  std::vector<std::int32_t> buttons{};  ///< 1 while pressed, otherwise 0

  bool operator==(const Joystick&) const = default;
};

}  // namespace tendon::robot

namespace tendon {

template <>
inline constexpr auto kPayload<robot::Joystick> =
    Describe("sensor_msgs.Joy", Field{"header", &robot::Joystick::header},
             Field{"axes", &robot::Joystick::axes}.Within(-1, 1).Help("0 if the axis is released."),
             Field{"buttons", &robot::Joystick::buttons}.Within(0, 1).Help(
                 "1 while the button is pressed."));

}  // namespace tendon
