#pragma once

#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/channel.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <vector>

namespace tendon::server {

/// Sends every change to every watcher, in order. A watcher is a position in one shared log, so a
/// slow watcher delays nobody and costs nothing. If the log no longer has its position, the watcher
/// gets only the newest change, sees the gap, and asks for a snapshot. Not thread-safe; never
/// blocks.
class Watchers {
 public:
  /// Adds a watcher that has everything up to `revision`; restarts a watcher that already exists.
  void Add(const std::shared_ptr<Channel>& channel, std::uint64_t revision);
  void Remove(const Channel* channel);

  /// The catalogue's next changes.
  void Publish(const std::vector<CatalogueChange>& changes);

  /// Sends what the watchers' links accept now.
  void Pump();

 private:
  static constexpr std::size_t kMostInBatch = 256;

  struct Watcher {
    std::shared_ptr<Channel> channel;
    std::uint64_t revision = 0;       ///< changes up to this revision were sent
    std::size_t most = kMostInBatch;  ///< most changes in one batch; fewer while its link is full
  };
  /// A frame for several watchers.
  struct Batch {
    std::uint64_t after = 0;
    std::uint64_t last = 0;
    Bytes body;
  };

  void Pump(Watcher& watcher, Batch& batch) const;
  void Fill(Batch& batch, const Watcher& watcher) const;
  void DropSent();

  std::deque<CatalogueChange> log_;  // changes that some watchers do not have yet
  std::uint64_t newest_ = 0;
  std::map<const Channel*, Watcher> watchers_;
};

}  // namespace tendon::server
