#include <tendon/process/telemetry/past_rows_reading.h>

#include <tendon/process/telemetry/row_batch.h>

#include <algorithm>
#include <utility>

namespace tendon {

PastRowsReading::PastRowsReading(TableSubscription table, std::chrono::nanoseconds last,
                                 std::shared_ptr<RowSink> sink, Done done)
    : subscription_(std::move(table), std::move(sink)), done_(std::move(done)) {
  const TableSubscription& wanted = subscription_.wanted();
  next_ = {.component = wanted.component,
           .table = wanted.table,
           .columns = wanted.columns,
           .last = last};
}

bool PastRowsReading::Take(const message::ReadRowsReply& page, const ClockOffset& clock) {
  if (const auto taken = TryTake(page, clock); !taken) {
    Fail(taken.error());
    return false;
  }
  const bool is_last = next_.first_tick >= end_tick_;
  if (is_last) Finish();
  return !is_last && !has_ended();
}

void PastRowsReading::Fail(const Error& reason) {
  read_.failure = reason;
  Finish();
}

void PastRowsReading::Finish() {
  const std::scoped_lock lock(mutex_);
  if (done_) done_(read_);
}

bool PastRowsReading::has_ended() {
  const std::scoped_lock lock(mutex_);
  return !done_;
}

void PastRowsReading::End() {
  {
    const std::scoped_lock lock(mutex_);
    done_ = nullptr;  // first, so that it does not report rows that the sink did not get
  }
  subscription_.End();
}

Result<void> PastRowsReading::TryTake(const message::ReadRowsReply& page,
                                      const ClockOffset& clock) {
  const Error invalid{ErrorCode::kInvalid,
                      "process '" + process() + "' sent invalid rows of its history"};
  const auto batch = RowBatchReader::Open(page.rows);
  if (!batch || batch->header().columns != subscription_.wanted().columns.size()) return invalid;
  const message::RowsHeader& header = batch->header();
  if (next_.epoch == 0) {
    const auto begun = subscription_.Begin(page.subscribed);
    if (!begun) return begun.error();
    beginning_ = *begun;
    next_.epoch = page.subscribed.epoch;
    next_.first_tick = page.subscribed.first_tick;
    end_tick_ = page.end_tick;
    const auto time_of = [](std::int64_t time) {
      return ClockOffset::Sensible(SteadyTime(std::chrono::nanoseconds(time)));
    };
    if (header.rows > 0) read_.reach = time_of(page.now) - time_of(batch->time(0));
  }
  const bool goes_on = header.next_tick > next_.first_tick || next_.first_tick >= end_tick_;
  if (page.subscribed.epoch != next_.epoch || !goes_on) return invalid;
  subscription_.Deliver(beginning_, page.rows, clock);
  next_.first_tick = header.next_tick;
  next_.rows_before += header.rows;
  read_.rows += header.rows;
  read_.lost += header.lost_table;
  return {};
}

}  // namespace tendon
