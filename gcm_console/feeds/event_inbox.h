#pragma once

#include <gcm_console/feeds/inbox_queue.h>
#include <tendon/gcm/client.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace console {

/// An event that was raised.
struct ReceivedEvent {
  /// ns since 1970 by this machine's clock, from the event's age on the steady clock.
  std::int64_t time_ns = 0;
  std::int64_t uncertainty_ns = -1;  ///< the possible error of `time_ns`; below 0: unknown
  std::string path;                  ///< "robot/arm/Control.GoalReached"
  tendon::MemberDescription description;
  std::vector<std::byte> value;  ///< the CDR body of the event's type
};

/// The number of lost events by path.
struct LostEvents {
  std::map<std::string, std::uint64_t> by_path;

  LostEvents& operator+=(const LostEvents& other);
};

/// Keeps the events of all interfaces until the printing thread takes them. The queue is bounded in
/// events and bytes; when it is full, the oldest events are dropped and counted as lost here.
class EventInbox final : public tendon::GcmListener,
                         public std::enable_shared_from_this<EventInbox> {
 public:
  using Events = InboxQueue<ReceivedEvent, LostEvents>;

  struct Content {
    bool is_catalog_new = false;
    std::vector<tendon::EventSubscription> begun;         ///< since the last Take()
    std::vector<tendon::MemberDescription> descriptions;  ///< the events of `begun`
    std::deque<Events::Entry> events;
    LostEvents lost;                        ///< after the last of `events`
    std::vector<tendon::Error> complaints;  ///< kUnreachable: about the GCM; else a process
    bool is_gcm_back = false;               ///< after a complaint about it
    bool has_more = false;                  ///< more events are waiting
  };

  /// The sink that passes the events of one interface to this inbox.
  std::shared_ptr<tendon::EventSink> SinkOf(const tendon::EventSubscription& subscription);

  /// Takes everything since the last call; the oldest events first.
  Content Take();

  void OnSnapshot(const tendon::Catalogue& catalogue) override;
  void OnChanges(const std::vector<tendon::CatalogueChange>& changes) override;
  void OnGcmLost(const tendon::Error& reason) override;

 private:
  class Sink;

  void Complain(const tendon::Error& complaint);

  std::mutex mutex_;
  Content content_;  // without the events and what is lost
  Events events_;
  bool is_gcm_lost_ = false;
};

}  // namespace console
