#pragma once

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

/// Keeps what is heard of all interfaces until the printing thread takes it. Events beyond
/// kMostWaiting are counted as lost here.
class EventInbox final : public tendon::GcmListener,
                         public std::enable_shared_from_this<EventInbox> {
 public:
  static constexpr std::size_t kMostWaiting = 100000;

  struct Content {
    bool is_catalog_new = false;
    std::vector<tendon::EventSubscription> begun;         ///< that are listened to from now on
    std::vector<tendon::MemberDescription> descriptions;  ///< of the events of those
    std::deque<HeardEvent> events;
    std::map<std::string, std::uint64_t> lost;  ///< since the last time, by path
    std::vector<tendon::Error> complaints;      ///< kUnreachable: of the GCM; else of a process
  };

  /// Who hears the events of one interface for us.
  std::shared_ptr<tendon::EventSink> SinkOf(const tendon::EventSubscription& subscription);

  /// All since the last time.
  Content Take();

  void OnSnapshot(const tendon::Catalog& catalog) override;
  void OnChanges(const std::vector<tendon::CatalogChange>& changes) override;
  void OnGcmLost(const tendon::Error& reason) override;

 private:
  class Sink;

  std::mutex mutex_;
  Content content_;
};

}  // namespace console
