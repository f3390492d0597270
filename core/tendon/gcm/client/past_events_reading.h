#pragma once

#include <tendon/gcm/event_sink.h>
#include <tendon/process/history/history_messages.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon::client {

class SourceClock;

/// Reads the kept events of one interface page by page, for EventFeed::ReadPast().
///
/// Thread safety: from any thread, one call at a time. Only End() may be called beside another
/// call.
class PastEventsReading {
 public:
  using Done = std::function<void(const PastEvents&)>;

  PastEventsReading(EventSubscription wanted, std::chrono::nanoseconds last,
                    std::shared_ptr<EventSink> sink, Done done);

  [[nodiscard]] const EventSubscription& wanted() const { return wanted_; }
  /// Sets the descriptions of the wanted events. Must be called before Take().
  void SetEvents(std::vector<MemberDescription> events) { events_ = std::move(events); }
  [[nodiscard]] const message::ReadEvents& NextRequest() const { return next_; }
  /// Passes the events of a page to the sink. Returns true if another page must be requested, and
  /// false after End().
  /// Before it returns false, it calls `done`. The page is untrusted.
  [[nodiscard]] bool Take(const message::ReadEventsReply& page, const SourceClock& clock);
  /// Calls `done` with this failure.
  void Fail(const Error& reason);
  /// After this function has returned, neither the sink nor `done` is called.
  void End();

 private:
  /// Passes the events of a page to the sink. Returns an error if the page is invalid.
  [[nodiscard]] Result<void> TryTake(const message::ReadEventsReply& page,
                                     const SourceClock& clock);

  const EventSubscription wanted_;
  std::mutex mutex_;  // guards the next two members
  std::shared_ptr<EventSink> sink_;
  Done done_;  // empty after End(), like the sink
  std::vector<MemberDescription> events_;
  message::ReadEvents next_;
  PastEvents read_;
  std::uint64_t end_ = 0;  // events from this number on were raised after the first request
};

}  // namespace tendon::client
