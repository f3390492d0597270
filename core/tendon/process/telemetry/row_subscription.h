#pragma once

#include <tendon/process/messages.h>
#include <tendon/process/telemetry/clock_offset.h>
#include <tendon/process/telemetry_client.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

class RowBatchReader;

/// One subscription of a viewer: turns what arrives into calls of its sink, and counts what did not
/// arrive. Any thread, one after the other; after End() the sink is not called any more.
class RowSubscription {
 public:
  RowSubscription(TableSubscription wanted, std::shared_ptr<RowSink> sink)
      : wanted_(std::move(wanted)), sink_(std::move(sink)) {}

  [[nodiscard]] const TableSubscription& wanted() const { return wanted_; }

  /// It stands; an error when the answer makes no sense. What was written since it stood before is
  /// lost. Returns how often it has stood: a number for its batches.
  Result<std::uint64_t> Begin(const message::Subscribed& subscribed);
  /// The same where the rows come by a topic: it goes on with the first batch that arrives.
  Result<std::uint64_t> BeginTopic(const message::Subscribed& subscribed);
  /// A batch of the `beginning`; one of an earlier or malformed is passed over, and so are its
  /// rows.
  void Deliver(std::uint64_t beginning, std::span<const std::byte> body, const ClockOffset& clock);
  /// There are no rows for now; said once for a reason.
  void Interrupt(const Error& reason);
  void End();

  [[nodiscard]] RowCounts counts() const;

 private:
  enum class From { kFirstTick, kFirstBatch };
  Result<std::uint64_t> Begin(const message::Subscribed& subscribed, From from);
  /// What was written since the last row is lost; now comes that of `first_tick`.
  void GoOn(std::uint64_t first_tick);
  /// False where the batch is of before.
  bool GoOnWith(const RowBatchReader& batch);
  [[nodiscard]] bool GoesForward(const RowBatchReader& batch) const;
  [[nodiscard]] std::uint64_t LostInTable(const message::RowsHeader& header,
                                          std::uint64_t lost_here) const;
  void ReadStamps(const RowBatchReader& reader);
  /// What is taken off the times of the rows of this batch.
  [[nodiscard]] std::chrono::nanoseconds Correction(const ClockOffset& clock);

  const TableSubscription wanted_;
  mutable std::mutex mutex_;
  std::shared_ptr<RowSink> sink_;
  Error interruption_;
  std::uint64_t beginnings_ = 0;
  std::uint64_t epoch_ = 0;
  bool has_begun_ = false;  // next_tick_ means something
  bool goes_on_ = false;    // with the ticks of before
  bool is_of_topic_ = false;
  bool waits_for_batch_ = false;      // which says where it begins
  std::uint64_t next_tick_ = 0;       // what has become of earlier rows is known
  std::uint64_t rows_ = 0;            // that were sent since it stands, as far as is known
  std::uint64_t lost_between_ = 0;    // while it did not stand, until a batch tells the sink
  std::optional<SteadyTime> newest_;  // row, corrected
  RowCounts counts_;
  std::vector<std::uint64_t> ticks_;
  std::vector<std::int64_t> times_;
};

}  // namespace tendon
