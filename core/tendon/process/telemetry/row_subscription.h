#pragma once

#include <tendon/process/messages.h>
#include <tendon/process/telemetry_client.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace tendon {

/// One subscription of a viewer: turns what arrives into calls of its sink, and counts what did not
/// arrive. Any thread, one after the other; after End() the sink is not called any more.
class RowSubscription {
 public:
  RowSubscription(TableSubscription wanted, std::shared_ptr<RowSink> sink)
      : wanted_(std::move(wanted)), sink_(std::move(sink)) {}

  [[nodiscard]] const TableSubscription& wanted() const { return wanted_; }

  /// It stands; an error when the answer makes no sense.
  Result<void> Begin(const message::Subscribed& subscribed);
  /// A batch; one that is malformed is passed over, and so are its rows.
  void Deliver(std::span<const std::byte> body);
  /// There are no rows for now; said once for a reason.
  void Interrupt(const Error& reason);
  void End();

 private:
  const TableSubscription wanted_;
  std::mutex mutex_;
  std::shared_ptr<RowSink> sink_;
  Error interruption_;
  std::uint64_t epoch_ = 0;
  std::uint64_t rows_ = 0;  // that were sent, as far as is known
  std::vector<std::uint64_t> ticks_;
  std::vector<std::int64_t> times_;
};

}  // namespace tendon
