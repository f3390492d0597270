#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/base/name.h>
#include <tendon/interface/interface_description.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// The wanted events of a provided interface: {"robot", "arm", "Control"}, {"GoalReached"}. The
/// calls of its commands can be subscribed to as if they were events; the value is then an observed
/// call, see SchemaOfCalls().
struct EventSubscription {
  InterfaceName provided{};
  std::vector<std::string> events{};
  std::vector<std::string> commands = {};  ///< no reads; see CanBeObserved()
  /// The number of events that may wait in the sending process. Further events are lost.
  std::uint32_t capacity = 1024;

  [[nodiscard]] std::size_t size() const { return events.size() + commands.size(); }
  /// Counts the events first, and then the commands.
  [[nodiscard]] bool is_command(std::size_t index) const { return index >= events.size(); }
  [[nodiscard]] const std::string& name(std::size_t index) const {
    return is_command(index) ? commands.at(index - events.size()) : events[index];
  }
  /// "robot/arm/Control.GoalReached"
  [[nodiscard]] std::string path(std::size_t index) const {
    return ToString(provided) + "." + name(index);
  }
  bool operator==(const EventSubscription&) const = default;
};

/// The result of ReadPastEvents().
struct PastEvents {
  std::uint64_t events = 0;  ///< events that were read
  /// The number of missing events: they were raised between the events that were read, but were not
  /// kept. Includes events of the interface that were not requested.
  std::uint64_t lost = 0;
  std::optional<Error> failure{};  ///< the reason why not all events could be read
};

/// The time when an event was raised.
struct EventTime {
  SteadyTime raised{};  ///< on the steady clock of the receiving process; never later than now
  /// The largest possible error of `raised`: at most half a round trip, about 10 us on one host. If
  /// the clock of the sending process is unknown, `raised` is the time of arrival, and this is the
  /// largest value of the type.
  std::chrono::nanoseconds uncertainty = std::chrono::nanoseconds::max();
};

/// Receives events, in threads of the client or the middleware, one call at a time; must not block.
/// `event` is an index in EventSubscription::events. Larger numbers are for the elements of
/// EventSubscription::commands.
class EventSink {
 public:
  virtual ~EventSink() = default;
  /// Called when the subscription becomes active. From now on, each event is delivered or reported
  /// as lost. Called again after each interruption, with the present types of the process. The
  /// types of a command are those of its argument and its result.
  virtual void OnListening(const std::vector<MemberDescription>& events) = 0;
  /// Called for each event. `value` is the CDR body of the event's type; empty if the event has no
  /// type.
  virtual void OnEvent(std::size_t event, std::span<const std::byte> value,
                       const EventTime& time) = 0;
  /// Called when `lost` more events were raised but not delivered.
  virtual void OnEventsLost(std::size_t event, std::uint64_t lost) = 0;
  /// Called when the subscription is interrupted or could not be made. The client keeps trying.
  virtual void OnStale(const Error& reason) = 0;
};

}  // namespace tendon
