#pragma once

#include <tendon/payload/cdr.h>
#include <tendon/payload/payload.h>

#include <chrono>
#include <cstdint>

/// Allows the use of std::chrono::sys_time, a time point of the system clock, as a payload. Include
/// this header if a payload has such a member. On the wire, a time point is builtin_interfaces/Time
/// of ROS 2. Time points of the steady clock are not payloads, because they mean nothing on another
/// machine.
namespace tendon {

namespace payload {

/// The time since 1970-01-01 00:00 UTC.
struct TimeOnWire {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
};

/// A time before 1901 or after 2038 becomes the nearest time that fits into int32 seconds.
template <TimeSpan Span>
struct SubstituteFor<std::chrono::sys_time<Span>> {
  using Type = TimeOnWire;

  static Type From(std::chrono::sys_time<Span> time) {
    const CdrDuration since_1970 = ToCdr(time.time_since_epoch());
    return {since_1970.sec, since_1970.nanosec};
  }
  /// Returns false if `wire` has a billion nanoseconds or more.
  static bool Into(const Type& wire, std::chrono::sys_time<Span>& time) {
    Span since_1970{};
    if (!FromCdr({wire.sec, wire.nanosec}, since_1970)) return false;
    time = std::chrono::sys_time<Span>(since_1970);
    return true;
  }
};

}  // namespace payload

template <>
inline constexpr auto kPayload<payload::TimeOnWire> =
    Describe("builtin_interfaces.Time", Field{"sec", &payload::TimeOnWire::sec, "s"},
             Field{"nanosec", &payload::TimeOnWire::nanosec, "ns"});

}  // namespace tendon
