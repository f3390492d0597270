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

/// For each channel, the subscriptions whose last row was acknowledged.
using RowAcknowledgements = std::map<std::shared_ptr<Channel>, std::set<std::uint32_t>>;

[[nodiscard]] bool Includes(const RowAcknowledgements& receipts,
                            const std::shared_ptr<Channel>& channel, std::uint32_t handle);

/// Collects acknowledgements until the network thread next sends rows, so that each one costs
/// little. Thread-safe.
class AcknowledgementQueue {
 public:
  /// The largest number of waiting acknowledgements of one viewer: twice its subscriptions, some of
  /// which may just have ended.
  static constexpr std::size_t kMostOfOneViewer = 4096;

  /// Adds one. Closes the channel of a viewer that exceeds the limit.
  void Add(const std::shared_ptr<Channel>& channel, std::uint32_t handle);
  /// Wait-free if there are none.
  [[nodiscard]] RowAcknowledgements TakeAll();

 private:
  Flag has_some_;
  std::mutex mutex_;
  RowAcknowledgements receipts_;
};

}  // namespace tendon
