#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/base/name.h>
#include <tendon/interface/description.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Which events of which provided interface: {"robot", "arm", "Control"}, {"GoalReached"}.
struct EventSubscription {
  InterfaceName provided;
  std::vector<std::string> events;
  /// Events that may wait in their process until they are sent; what finds no room is lost.
  std::uint32_t capacity = 1024;
};

/// When an event was raised, by the steady clock of its source.
struct EventTime {
  SteadyTime raised;  ///< as this process' steady clock had it then; never later than now
  /// How far that may be off, as two clocks are compared by asking: half a way there and back at
  /// most, some 10 us on one host. The largest value where the other clock tells nothing sensible;
  /// then `raised` is when it arrived.
  std::chrono::nanoseconds uncertainty = std::chrono::nanoseconds::max();
};

/// What a listener to events hears, in threads of the client or the middleware, one call at a time;
/// must not block. `event` is the place in EventSubscription::events.
class EventSink {
 public:
  virtual ~EventSink() = default;
  /// From now on each event is heard, or told of as lost. Again after healing; the types are those
  /// that the process has now.
  virtual void OnListening(const std::vector<MemberDescription>& events) = 0;
  /// It was raised; `value` is the CDR body of its type, empty where it carries none.
  virtual void OnEvent(std::size_t event, std::span<const std::byte> value,
                       const EventTime& time) = 0;
  /// So many more were raised for which there was no room.
  virtual void OnEventsLost(std::size_t event, std::uint64_t lost) = 0;
  /// Nothing is heard for now; the client tries again by itself.
  virtual void OnStale(const Error& reason) = 0;
};

}  // namespace tendon
