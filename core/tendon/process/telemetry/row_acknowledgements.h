#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>

namespace tendon {

/// By channel: the subscriptions whose viewer has acknowledged the last row.
using RowAcknowledgements = std::map<std::shared_ptr<Channel>, std::set<std::uint32_t>>;

[[nodiscard]] bool Includes(const RowAcknowledgements& receipts,
                            const std::shared_ptr<Channel>& channel, std::uint32_t handle);

/// Collects acknowledgements until the next gathering, so that each costs little. Thread-safe.
class AcknowledgementQueue {
 public:
  /// The most that wait for one viewer: twice its subscriptions, some of which may just have ended.
  static constexpr std::size_t kMostOfOneViewer = 4096;

  /// Cuts off a viewer that exceeds this.
  void Add(const std::shared_ptr<Channel>& channel, std::uint32_t handle);
  /// Wait-free if there are none.
  [[nodiscard]] RowAcknowledgements TakeAll();

 private:
  Flag has_some_;
  std::mutex mutex_;
  RowAcknowledgements receipts_;
};

}  // namespace tendon
