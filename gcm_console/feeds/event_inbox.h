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

/// An event that a component has raised, or a call of a command.
struct ReceivedEvent {
  /// The time in ns since 1970 by this machine's clock; for a call, the start of its execution. It
  /// is computed from the age of the event, which is measured on the steady clock.
  std::int64_t time_ns = 0;
  std::int64_t uncertainty_ns = -1;  ///< maximum error of `time_ns`; below 0 if unknown
  std::string path;                  ///< "robot/arm/Control.GoalReached"
  tendon::MemberDescription description;
  std::vector<std::byte> value;  ///< value of the event, encoded as CDR
  bool is_call = false;          ///< the value has the type SchemaOfCalls()
};

/// The number of lost events by path.
struct LostEvents {
  std::map<std::string, std::uint64_t> by_path;

  LostEvents& operator+=(const LostEvents& other);
};

/// Stores the events of all interfaces until the printing thread takes them. The queue is limited
/// in events and bytes. When it is full, the oldest events are dropped and counted as lost.
class EventInbox final : public tendon::GcmListener,
                         public std::enable_shared_from_this<EventInbox> {
 public:
  using Events = InboxQueue<ReceivedEvent, LostEvents>;

  struct Content {
    bool is_catalog_new = false;
    std::vector<tendon::EventSubscription> begun;         ///< begun since the last Take()
    std::vector<tendon::MemberDescription> descriptions;  ///< descriptions of the events in `begun`
    std::deque<Events::Entry> events;
    LostEvents lost;  ///< events lost after the last of `events`
    /// kUnreachable: errors of the GCM; other codes: errors of a process
    std::vector<tendon::Error> complaints;
    bool is_gcm_back = false;  ///< true if the GCM was lost and has returned
    bool has_more = false;     ///< true if more events can be taken
  };

  /// Returns the sink that passes the events of one interface to this inbox.
  std::shared_ptr<tendon::EventSink> SinkOf(const tendon::EventSubscription& subscription);

  /// Takes everything that has arrived since the last call; the oldest events come first.
  Content Take();

  void OnSnapshot(const tendon::Catalogue& catalogue) override;
  void OnChanges(const std::vector<tendon::CatalogueChange>& changes) override;
  void OnGcmLost(const tendon::Error& reason) override;

 private:
  class Sink;

  void Complain(const tendon::Error& complaint);

  std::mutex mutex_;
  Content content_;  // without the events and the losses
  Events events_;
  bool is_gcm_lost_ = false;
};

}  // namespace console
