#pragma once

#include <tendon/gcm/client/event_listener.h>
#include <tendon/gcm/client/past_events_reading.h>
#include <tendon/gcm/client/process_links.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon::client {

/// Subscribes to events of processes on the channels of ProcessLinks. A process treats a
/// subscription like the connection of a required interface that has only event handlers.
/// Interrupted subscriptions are requested again twice a second. Thread-safe.
class EventFeed final : public ChannelHandler, public std::enable_shared_from_this<EventFeed> {
 public:
  using Id = std::uint64_t;
  /// Looks up the wanted events in the current catalogue. Returns their descriptions in the same
  /// order, or an error that says what is missing.
  using LookUp = std::function<Result<std::vector<MemberDescription>>(const EventSubscription&)>;

  /// `name` is the name of this program in the logs of the processes. The thread of `timer` must
  /// never block.
  EventFeed(std::shared_ptr<ProcessLinks> links, std::shared_ptr<Worker> timer, LookUp look_up,
            std::string name, std::chrono::milliseconds timeout);

  Id Listen(EventSubscription wanted, std::shared_ptr<EventSink> sink);
  /// Ends a subscription. After this function has returned, the sink is not called any more.
  void End(Id id);
  /// Reads the events that the process has kept and that are not older than `last`, oldest first.
  /// The sink gets OnListening(), then OnEvent(). Then `done` is called once, in a thread of the
  /// middleware or of the timer, or before this function returns, if the reading fails at once.
  void ReadPast(EventSubscription wanted, std::chrono::nanoseconds last,
                std::shared_ptr<EventSink> sink, PastEventsReading::Done done);
  /// Requests the interrupted subscriptions to a process again at once. Must be called when the
  /// process has returned or has a new address.
  void Retry(const std::string& process);
  /// Ends all subscriptions and readings, and begins no new ones. After this function has returned,
  /// no sink and no `done` is called.
  void Stop();

  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) override;
  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override;

 private:
  using SharedListener = std::shared_ptr<EventListener>;
  /// Channel and attempt. The channel is part of the key, because a notice counts only if it
  /// arrives on the channel of the subscription.
  using Key = std::pair<const Channel*, std::uint32_t>;

  void Subscribe(const SharedListener& listener);
  using SharedClock = std::shared_ptr<SourceClock>;
  SharedClock ClockOf(const std::shared_ptr<Channel>& channel);
  using SharedReading = std::shared_ptr<PastEventsReading>;
  /// Adds a reading to readings_ if the feed has not ended.
  [[nodiscard]] bool Keep(const SharedReading& reading);
  void AskForPast(const SharedReading& reading, const std::shared_ptr<Channel>& channel,
                  const SharedClock& clock);
  void Ask(const SharedListener& listener, const std::shared_ptr<Channel>& channel,
           const SharedClock& clock, std::uint32_t attempt);
  void Fail(const SharedListener& listener, std::uint32_t attempt, const Error& reason);
  /// Finds the subscription to which `handle` belongs, and its attempt. `handle` is the number of
  /// the attempt or of one of its events.
  std::pair<SharedListener, std::uint32_t> Find(const Channel* channel, std::uint32_t handle);
  SharedListener Take(const Key& key);

  const std::shared_ptr<ProcessLinks> links_;
  const std::shared_ptr<Worker> timer_;
  const LookUp look_up_;
  const std::string name_;
  const std::chrono::milliseconds timeout_;
  std::mutex mutex_;
  std::map<Id, SharedListener> listeners_;
  std::map<Key, SharedListener> active_;
  std::vector<std::weak_ptr<PastEventsReading>> readings_;
  bool is_stopped_ = false;
  std::map<const Channel*, std::weak_ptr<SourceClock>> clocks_;
  Id last_id_ = 0;
  std::uint32_t next_handle_ = 1;
};

}  // namespace tendon::client
