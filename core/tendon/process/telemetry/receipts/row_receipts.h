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

/// By channel: the subscriptions whose viewer has taken the row that it was sent last.
using RowReceipts = std::map<std::shared_ptr<Channel>, std::set<std::uint32_t>>;

[[nodiscard]] bool Includes(const RowReceipts& receipts, const std::shared_ptr<Channel>& channel,
                            std::uint32_t handle);

/// Where receipts wait until rows are gathered again, so that each costs next to nothing.
/// Thread-safe.
class ReceiptBox {
 public:
  /// That wait of one viewer: twice as many as it has subscriptions, which may just have ended.
  static constexpr std::size_t kMostOfOneViewer = 4096;

  /// Cuts off a viewer that sends more.
  void Add(const std::shared_ptr<Channel>& channel, std::uint32_t handle);
  /// Wait-free where there are none.
  [[nodiscard]] RowReceipts TakeAll();

 private:
  Flag has_some_;
  std::mutex mutex_;
  RowReceipts receipts_;
};

}  // namespace tendon
