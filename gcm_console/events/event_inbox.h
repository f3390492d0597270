#pragma once

#include <tendon/base/dropping_queue.h>
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
struct HeardEvent {
  /// When it was raised, by the steady clock of its process: since 1970, by this machine's clock.
  std::int64_t time_ns = 0;
  std::int64_t uncertainty_ns = -1;  ///< how far that may be off; below 0: nobody knows
  std::string path;                  ///< "robot/arm/Control.GoalReached"
  tendon::MemberDescription description;
  std::vector<std::byte> value;  ///< the CDR body of its type
};

/// Keeps what is heard of all interfaces until the printing thread takes it. What waits is bounded
/// in events and bytes; newer ones take the place of the oldest, which are counted as lost here.
class EventInbox final : public tendon::GcmListener,
                         public std::enable_shared_from_this<EventInbox> {
 public:
  static constexpr tendon::QueueBound kMostWaiting = {.elements = 100000,
                                                      .bytes = std::size_t{32} << 20U};
  /// At one go, or a single event.
  static constexpr std::size_t kMostTaken = std::size_t{1} << 20U;  // bytes

  struct Content {
    bool is_catalog_new = false;
    std::vector<tendon::EventSubscription> begun;         ///< that are listened to from now on
    std::vector<tendon::MemberDescription> descriptions;  ///< of the events of those
    std::deque<HeardEvent> events;
    std::map<std::string, std::uint64_t> lost;  ///< since the last time, by path
    std::vector<tendon::Error> complaints;      ///< kUnreachable: of the GCM; else of a process
    bool is_gcm_back = false;                   ///< after a complaint of it
    bool has_more = false;                      ///< events that wait
  };

  /// Who hears the events of one interface for us.
  std::shared_ptr<tendon::EventSink> SinkOf(const tendon::EventSubscription& subscription);

  /// What has come since the last time; of the events the oldest that wait.
  Content Take();

  void OnSnapshot(const tendon::Catalog& catalog) override;
  void OnChanges(const std::vector<tendon::CatalogChange>& changes) override;
  void OnGcmLost(const tendon::Error& reason) override;

 private:
  class Sink;

  void Complain(const tendon::Error& complaint);

  std::mutex mutex_;
  Content content_;  // but for the events
  tendon::DroppingQueue<HeardEvent> events_{kMostWaiting};
  bool is_gcm_lost_ = false;
};

}  // namespace console
