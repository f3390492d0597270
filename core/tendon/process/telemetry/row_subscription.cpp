#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_subscription.h>

#include <algorithm>
#include <utility>

namespace tendon {

Result<std::uint64_t> RowSubscription::Begin(const message::Subscribed& subscribed) {
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
  const bool goes_on = beginnings_ > 0 && epoch_ == subscribed.epoch;
  if (goes_on && wanted_.rows == RowChoice{}) {
    lost_between_ += subscribed.first_tick - std::min(next_tick_, subscribed.first_tick);
  }
  if (!goes_on) newest_.reset();
  ++beginnings_;
  epoch_ = subscribed.epoch;
  next_tick_ = subscribed.first_tick;
  rows_ = 0;
  interruption_ = {};
  if (sink_) sink_->OnSubscribed(schemas);
  return beginnings_;
}

void RowSubscription::Deliver(std::uint64_t beginning, std::span<const std::byte> body,
                              const ClockOffset& clock) {
  const auto reader = RowBatchReader::Open(body);
  if (!reader || reader->header().columns != wanted_.columns.size()) return;
  const message::RowsHeader& header = reader->header();
  const std::scoped_lock lock(mutex_);
  if (beginning != beginnings_) return;
  ReadStamps(*reader);
  RowBatch batch;
  batch.epoch = epoch_;
  batch.lost_table = header.lost_table;
  batch.lost_network =
      header.rows_before - std::min(rows_, header.rows_before) + std::exchange(lost_between_, 0);
  batch.count = header.rows;
  batch.ticks = ticks_;
  batch.times = times_;
  batch.clock_offset = Correction(clock);
  batch.clock_uncertainty = clock.At(SteadyClock().Now()).uncertainty;
  batch.cell = [&reader](std::size_t row, std::size_t column) { return reader->cell(row, column); };
  rows_ = header.rows_before + header.rows;
  next_tick_ = header.next_tick;
  counts_.received += batch.count;
  counts_.lost_table += batch.lost_table;
  counts_.lost_network += batch.lost_network;
  if (sink_) counts_.lost_viewer += sink_->OnRows(batch);
}

void RowSubscription::ReadStamps(const RowBatchReader& reader) {
  ticks_.clear();
  times_.clear();
  for (std::size_t row = 0; row < reader.header().rows; ++row) {
    ticks_.push_back(reader.tick(row));
    times_.push_back(reader.time(row));
  }
}

std::chrono::nanoseconds RowSubscription::Correction(const ClockOffset& clock) {
  constexpr std::chrono::seconds kMost(1);  // further back is no matter of correction
  if (times_.empty()) return {};
  const auto time_at = [](std::int64_t time) {
    return ClockOffset::Sensible(SteadyTime(std::chrono::nanoseconds(time)));
  };
  const SteadyTime first = time_at(times_.front());
  std::chrono::nanoseconds offset = clock.SlewedAt(first);
  if (newest_ && first - offset < *newest_ && *newest_ - (first - offset) < kMost) {
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

RowCounts RowSubscription::counts() const {
  const std::scoped_lock lock(mutex_);
  RowCounts counts = counts_;
  counts.lost_network += lost_between_;
  return counts;
}

}  // namespace tendon
