#pragma once

#include <tendon/gcm/client/source_clock.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/messages.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tendon::client {

/// One listener to events of one interface: which attempt to reach it is under way, or stands, by
/// the number that was issued for it; what an earlier one still tells is passed over. Thread-safe;
/// after End() the sink is not called any more.
class Listening {
 public:
  Listening(EventSubscription wanted, std::shared_ptr<EventSink> sink)
      : wanted_(std::move(wanted)), sink_(std::move(sink)) {}

  [[nodiscard]] const EventSubscription& wanted() const { return wanted_; }

  /// False where one is under way or stands, or it has ended.
  bool Try(std::uint32_t attempt);
  /// Where it stands: its other end calls it `handle`.
  struct Place {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    std::shared_ptr<const SourceClock> clock;
  };
  /// Its other end answers. False where it is wanted no more.
  bool Stand(std::uint32_t attempt, Place place, const std::vector<MemberDescription>& events);
  /// It came to nothing, or is over: said once for a reason. False where that was known, or nobody
  /// wants to know; otherwise it is to be tried again later.
  bool Fail(std::uint32_t attempt, const Error& reason);
  void End();

  /// `there` is when it was raised, on the other end's clock.
  void Raise(std::uint32_t attempt, std::size_t event, std::span<const std::byte> value,
             SteadyTime there);
  /// So many ever since it stands.
  void Lose(std::uint32_t attempt, const message::EventsLost& events);

 private:
  const EventSubscription wanted_;
  std::mutex mutex_;
  std::shared_ptr<EventSink> sink_;  // null once it has ended
  std::uint32_t attempt_ = 0;        // 0: there is none
  Place place_;                      // without a channel: it does not stand
  std::vector<std::uint64_t> lost_;
  std::optional<Error> interruption_;
};

}  // namespace tendon::client
