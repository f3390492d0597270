#pragma once

#include <tendon/process/clock_offset.h>
#include <tendon/process/telemetry_client.h>
#include <tendon/process/viewer_messages.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

class RowBatchReader;

/// One subscription of a viewer. It passes arriving batches to its sink and counts lost rows. Any
/// thread may call it, but only one thread at a time. After End(), the sink is not called any more.
class RowSubscription {
 public:
  RowSubscription(TableSubscription wanted, std::shared_ptr<RowSink> sink)
      : wanted_(std::move(wanted)), sink_(std::move(sink)) {}

  [[nodiscard]] const TableSubscription& wanted() const { return wanted_; }

  /// The row with which the subscription starts. kFirstTick: the announced row. kFirstBatch: the
  /// first row that arrives, for rows that arrive through a topic.
  enum class Start { kFirstTick, kFirstBatch };
  /// Activates the subscription. Returns an error if the reply is invalid. Otherwise returns the
  /// number of this activation, which must be passed to Deliver(). Rows that were written while the
  /// subscription was inactive count as lost.
  Result<std::uint64_t> Begin(const message::SubscribeReply& subscribed,
                              Start start = Start::kFirstTick);
  /// Delivers a batch. `beginning` is the number of the activation, which Begin() has returned.
  /// Ignores batches that are malformed, out of order or from an earlier activation.
  void Deliver(std::uint64_t beginning, std::span<const std::byte> body, const ClockOffset& clock);
  /// Called when no rows arrive for now. Notifies the sink once for each reason.
  void Interrupt(const Error& reason);
  void End();

 private:
  /// Continues at `first_tick`. Counts the rows between the last row and `first_tick` as lost.
  void ContinueAt(std::uint64_t first_tick);
  /// Continues with the first row of a batch. Returns false if the batch is older than the last
  /// row.
  bool ContinueWith(const RowBatchReader& batch);
  [[nodiscard]] bool IsNewer(const RowBatchReader& batch) const;
  [[nodiscard]] std::uint64_t LostInTable(const message::RowsHeader& header,
                                          std::uint64_t lost_here) const;
  void ReadStamps(const RowBatchReader& reader);
  /// Returns the correction for the times of this batch.
  [[nodiscard]] std::chrono::nanoseconds Correction(const ClockOffset& clock);

  const TableSubscription wanted_;
  std::mutex mutex_;
  std::shared_ptr<RowSink> sink_;
  Error interruption_;
  std::uint64_t beginnings_ = 0;
  std::uint64_t epoch_ = 0;
  bool has_begun_ = false;  // true if next_tick_ is valid
  bool goes_on_ = false;    // true if ticks continue those of the last activation
  bool is_of_topic_ = false;
  bool waits_for_batch_ = false;      // true until the first batch sets the first tick
  std::uint64_t next_tick_ = 0;       // all rows before this tick are already counted
  std::uint64_t rows_ = 0;            // number of rows sent since the activation
  std::uint64_t lost_between_ = 0;    // rows lost while inactive; reported with the next batch
  std::optional<SteadyTime> newest_;  // corrected time of the newest row
  std::vector<std::uint64_t> ticks_;
  std::vector<std::int64_t> times_;
};

}  // namespace tendon
