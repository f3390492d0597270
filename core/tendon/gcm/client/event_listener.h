#pragma once

#include <tendon/gcm/client/source_clock.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/connection_messages.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tendon::client {

/// One subscription to events of one interface. Each attempt to subscribe has a number. Messages of
/// earlier attempts are ignored. After End(), the sink is not called any more. Thread-safe.
class EventListener {
 public:
  EventListener(EventSubscription wanted, std::shared_ptr<EventSink> sink)
      : wanted_(std::move(wanted)), sink_(std::move(sink)) {}

  [[nodiscard]] const EventSubscription& wanted() const { return wanted_; }

  /// Begins an attempt. Returns false if an earlier attempt is in progress or active, or if the
  /// subscription has ended.
  bool Try(std::uint32_t attempt);
  /// The accepted attempt: its channel, its number in the other process, and the clock of that
  /// process.
  struct Subscription {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    std::shared_ptr<const SourceClock> clock;
  };
  /// Called when the other process has accepted the attempt. Returns false if the attempt is
  /// outdated or the subscription has ended.
  bool OnSubscribed(std::uint32_t attempt, Subscription subscription,
                    const std::vector<MemberDescription>& events);
  /// Called when the attempt has failed or ended. Reports the reason to the sink, unless the last
  /// report had the same reason. Returns true if another attempt should follow later. Returns false
  /// if this attempt is outdated or the subscription has ended.
  bool Fail(std::uint32_t attempt, const Error& reason);
  void End();

  /// Passes an event to the sink. `there` is the time when the event was raised, on the clock of
  /// the other process.
  void Raise(std::uint32_t attempt, std::size_t event, std::span<const std::byte> value,
             SteadyTime there);
  /// Reports lost events to the sink. `events` has the total numbers since the attempt became
  /// active.
  void OnLost(std::uint32_t attempt, const message::EventsLost& events);

 private:
  const EventSubscription wanted_;
  std::mutex mutex_;
  std::shared_ptr<EventSink> sink_;  // null after End()
  std::uint32_t attempt_ = 0;        // 0: none
  Subscription subscription_;        // its channel is null while not active
  std::vector<std::uint64_t> lost_;
  std::optional<Error> interruption_;
};

}  // namespace tendon::client
