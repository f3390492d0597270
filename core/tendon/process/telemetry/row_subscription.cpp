#include <tendon/process/telemetry/row_subscription.h>

#include <tendon/process/telemetry/row_batch.h>

#include <algorithm>
#include <utility>

namespace tendon {

Result<std::uint64_t> RowSubscription::Begin(const message::SubscribeReply& subscribed,
                                             Start start) {
  if (subscribed.schemas.size() != wanted_.columns.size()) {
    return Error{ErrorCode::kInvalid, wanted_.process + " answered with another number of columns"};
  }
  std::vector<Schema> schemas;
  for (const std::string& text : subscribed.schemas) {
    auto schema = Schema::Parse(text);
    if (!schema) return schema.error();
    schemas.push_back(*std::move(schema));
  }
  const std::scoped_lock lock(mutex_);
  goes_on_ = has_begun_ && epoch_ == subscribed.epoch;
  if (!goes_on_) newest_.reset();
  ++beginnings_;
  epoch_ = subscribed.epoch;
  is_of_topic_ = start == Start::kFirstBatch;
  waits_for_batch_ = is_of_topic_;
  if (!goes_on_) has_begun_ = false;
  if (!waits_for_batch_) ContinueAt(subscribed.first_tick);
  rows_ = 0;
  interruption_ = {};
  if (sink_) sink_->OnSubscribed(schemas);
  return beginnings_;
}

void RowSubscription::ContinueAt(std::uint64_t first_tick) {
  if (goes_on_ && wanted_.rows == RowChoice{}) {
    lost_between_ += first_tick - std::min(next_tick_, first_tick);
  }
  // In a subscription to only the newest row, the first row may have been written before the
  // subscription.
  if (wanted_.rows.delivery != RowDelivery::kNewest) {
    next_tick_ = first_tick;
  } else if (!goes_on_) {
    next_tick_ = 0;
  }
  has_begun_ = true;
}

bool RowSubscription::ContinueWith(const RowBatchReader& batch) {
  const message::RowsHeader& header = batch.header();
  if (goes_on_ && header.next_tick <= next_tick_) return false;
  // The loss that this batch reports is ignored, because it may have happened before the
  // subscription.
  ContinueAt(header.rows == 0 ? header.next_tick : std::min(batch.tick(0), header.next_tick));
  rows_ = header.rows_before;
  waits_for_batch_ = false;
  return true;
}

void RowSubscription::Deliver(std::uint64_t beginning, std::span<const std::byte> body,
                              const ClockOffset& clock) {
  const auto reader = RowBatchReader::Open(body);
  if (!reader || reader->header().columns != wanted_.columns.size()) return;
  const message::RowsHeader& header = reader->header();
  const std::scoped_lock lock(mutex_);
  if (beginning != beginnings_) return;
  if (waits_for_batch_ && !ContinueWith(*reader)) return;
  if (!IsNewer(*reader)) return;
  ReadStamps(*reader);
  RowBatch batch;
  batch.epoch = epoch_;
  const std::uint64_t lost_here = header.rows_before - std::min(rows_, header.rows_before);
  batch.lost.table = LostInTable(header, lost_here);
  batch.lost.network = lost_here + std::exchange(lost_between_, 0);
  batch.count = header.rows;
  batch.ticks = ticks_;
  batch.times = times_;
  batch.clock_offset = Correction(clock);
  batch.clock_uncertainty = clock.At(SteadyClock().Now()).uncertainty;
  batch.cell = [&reader](std::size_t row, std::size_t column) { return reader->cell(row, column); };
  rows_ = header.rows_before + header.rows;
  next_tick_ = header.next_tick;
  if (sink_) sink_->OnRows(batch);
}

/// True if all rows of the batch are newer than the last row. Gaps between ticks are lost rows.
bool RowSubscription::IsNewer(const RowBatchReader& batch) const {
  const message::RowsHeader& header = batch.header();
  if (header.rows_before < rows_ || header.rows_before + header.rows < header.rows_before) {
    return false;
  }
  std::uint64_t next = next_tick_;
  for (std::size_t row = 0; row < header.rows; ++row) {
    if (batch.tick(row) < next || batch.tick(row) >= header.next_tick) return false;
    next = batch.tick(row) + 1;
  }
  return header.next_tick >= next;
}

/// Returns the number of rows that were lost in the table. For a topic, this number is computed
/// from ticks, because the batch that reported the loss may itself be lost.
std::uint64_t RowSubscription::LostInTable(const message::RowsHeader& header,
                                           std::uint64_t lost_here) const {
  if (!is_of_topic_) return header.lost_table;
  const std::uint64_t written = header.next_tick - std::min(next_tick_, header.next_tick);
  return written - std::min(lost_here + header.rows, written);
}

void RowSubscription::ReadStamps(const RowBatchReader& reader) {
  ticks_.clear();
  times_.clear();
  for (std::size_t row = 0; row < reader.header().rows; ++row) {
    ticks_.push_back(reader.tick(row));
    const SteadyTime time(std::chrono::nanoseconds(reader.time(row)));
    times_.push_back(ClockOffset::Sensible(time).time_since_epoch().count());
  }
}

std::chrono::nanoseconds RowSubscription::Correction(const ClockOffset& clock) {
  constexpr std::chrono::seconds kMax(1);  // a larger step back is a jump, not a correction
  if (times_.empty()) return {};
  const auto time_at = [](std::int64_t time) { return SteadyTime(std::chrono::nanoseconds(time)); };
  const SteadyTime first = time_at(times_.front());
  std::chrono::nanoseconds offset = clock.SlewedAt(first);
  if (newest_ && first - offset < *newest_ && *newest_ - (first - offset) < kMax) {
    offset = first - *newest_;
  }
  newest_ = time_at(times_.back()) - offset;
  return offset;
}

void RowSubscription::Interrupt(const Error& reason) {
  const std::scoped_lock lock(mutex_);
  if (reason == interruption_) return;
  interruption_ = reason;
  if (sink_) sink_->OnStale(reason);
}

void RowSubscription::End() {
  const std::scoped_lock lock(mutex_);
  sink_.reset();
}

}  // namespace tendon
