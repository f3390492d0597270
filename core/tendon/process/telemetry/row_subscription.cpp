#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_subscription.h>

#include <algorithm>
#include <utility>

namespace tendon {

Result<void> RowSubscription::Begin(const message::Subscribed& subscribed) {
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
  epoch_ = subscribed.epoch;
  rows_ = 0;
  interruption_ = {};
  if (sink_) sink_->OnSubscribed(schemas);
  return {};
}

void RowSubscription::Deliver(std::span<const std::byte> body) {
  const auto reader = RowBatchReader::Open(body);
  if (!reader || reader->header().columns != wanted_.columns.size()) return;
  const message::RowsHeader& header = reader->header();
  const std::scoped_lock lock(mutex_);
  ticks_.clear();
  times_.clear();
  for (std::size_t row = 0; row < header.rows; ++row) {
    ticks_.push_back(reader->tick(row));
    times_.push_back(reader->time(row));
  }
  RowBatch batch;
  batch.epoch = epoch_;
  batch.lost_table = header.lost_table;
  batch.lost_network = header.rows_before - std::min(rows_, header.rows_before);
  batch.count = header.rows;
  batch.ticks = ticks_;
  batch.times = times_;
  batch.cell = [&reader](std::size_t row, std::size_t column) { return reader->cell(row, column); };
  rows_ = header.rows_before + header.rows;
  if (sink_) sink_->OnRows(batch);
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
