#pragma once

#include <tendon/gcm/messages.h>
#include <tendon/middleware/channel.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

namespace tendon::server {

/// Sends every change to every watcher, in order. A watcher is a place in one log that all share:
/// who does not read stays behind, holds nobody up and costs nothing; who falls behind the log is
/// sent the newest change alone, sees the hole, and asks for a snapshot. Not thread-safe; never
/// blocks.
class Watchers {
 public:
  /// A watcher that has everything up to `revision`; one that is there already begins anew.
  void Add(const std::shared_ptr<Channel>& channel, std::uint64_t revision);
  void Remove(const Channel* channel);

  /// The catalogue's next changes.
  void Publish(const std::vector<CatalogChange>& changes);

  /// Sends what the watchers' links take now.
  void Pump();

 private:
  static constexpr std::size_t kMostInBatch = 256;

  struct Watcher {
    std::shared_ptr<Channel> channel;
    std::uint64_t revision = 0;       ///< sent up to here
    std::size_t most = kMostInBatch;  ///< changes tried at once; fewer while its link is full
  };
  /// A frame that several watchers need.
  struct Batch {
    std::uint64_t after = 0;
    std::uint64_t last = 0;
    Bytes body;
  };

  void Pump(Watcher& watcher, Batch& batch) const;
  void Fill(Batch& batch, const Watcher& watcher) const;
  void DropSent();

  std::deque<CatalogChange> log_;  // of what some watcher was not sent yet
  std::uint64_t newest_ = 0;
  std::map<const Channel*, Watcher> watchers_;
};

}  // namespace tendon::server
