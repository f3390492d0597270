#pragma once

#include <tendon/payload/payload.h>

#include <cstdint>

namespace arm {

/// The amount of motion of an arm.
struct Activity {
  double speed = 0.0;   ///< rad/s, of the fastest joint
  double energy = 0.0;  ///< J, estimated kinetic energy
};

/// The events that an arm has raised since the supervisor was started.
struct EventCounts {
  std::uint64_t goals = 0;   ///< goals reached
  std::uint64_t limits = 0;  ///< limits reached
};

}  // namespace arm

template <>
inline constexpr auto tendon::kPayload<arm::Activity> =
    tendon::Describe("arm.Activity", tendon::Field{"speed", &arm::Activity::speed, "rad/s"},
                     tendon::Field{"energy", &arm::Activity::energy, "J"});

template <>
inline constexpr auto tendon::kPayload<arm::EventCounts> =
    tendon::Describe("arm.EventCounts", tendon::Field{"goals", &arm::EventCounts::goals},
                     tendon::Field{"limits", &arm::EventCounts::limits});
