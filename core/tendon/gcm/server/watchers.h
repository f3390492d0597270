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

/// Sends every change of the catalogue to every watcher, in order. A watcher is only a position in
/// one shared list of changes, so a slow watcher does not delay others and needs no additional
/// memory. If the changes that a watcher needs are no longer in the list, it gets only the newest
/// change, detects the gap, and asks for a snapshot. Not thread-safe; never blocks.
class Watchers {
 public:
  /// Adds a watcher that has all changes up to `revision`. If the watcher already exists, sets its
  /// position to `revision`.
  void Add(const std::shared_ptr<Channel>& channel, std::uint64_t revision);
  void Remove(const Channel* channel);

  /// Adds the next changes of the catalogue and sends them.
  void Publish(const std::vector<CatalogueChange>& changes);

  /// Sends as many changes to each watcher as its link accepts now.
  void Pump();

 private:
  static constexpr std::size_t kMaxInBatch = 256;

  struct Watcher {
    std::shared_ptr<Channel> channel;
    std::uint64_t revision = 0;  ///< the last revision that was sent
    /// The largest number of changes in one batch; smaller while the link is full.
    std::size_t most = kMaxInBatch;
  };
  /// An encoded frame, which can be sent to several watchers.
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
