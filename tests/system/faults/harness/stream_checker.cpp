#include "system/faults/harness/stream_checker.h"

#include <tendon/payload/codec.h>

namespace faults {

StreamChecker::Verdict StreamChecker::verdict() const {
  const std::scoped_lock lock(mutex_);
  return verdict_;
}

void StreamChecker::OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) {
  const std::scoped_lock lock(mutex_);
  ++verdict_.subscriptions;
  last_tick_.reset();
}

void StreamChecker::OnStale(const tendon::Error& reason) {
  const std::scoped_lock lock(mutex_);
  verdict_.stale.push_back(reason.message);
}

void StreamChecker::OnRows(const tendon::RowBatch& batch) {
  const std::scoped_lock lock(mutex_);
  verdict_.counted += batch.lost.all();
  for (std::size_t row = 0; row < batch.count; ++row) {
    if (last_tick_ && batch.ticks[row] <= *last_tick_) ++verdict_.repeated;
    last_tick_ = batch.ticks[row];
    ++verdict_.received;
    Numbered sample;
    const bool is_whole = tendon::Decode(batch.cell(row, 0), sample) && IsWhole(sample);
    is_whole ? Take(sample) : static_cast<void>(++verdict_.damaged);
  }
}

void StreamChecker::Take(const Numbered& sample) {
  if (!last_ || last_->source != sample.source) {
    ++verdict_.ledgers;
  } else if (sample.number <= last_->number) {
    ++verdict_.repeated;
  } else {
    verdict_.missing += sample.number - last_->number - 1;
  }
  last_ = sample;
}

std::string ToString(const StreamChecker::Verdict& verdict) {
  return std::to_string(verdict.received) + " rows, " + std::to_string(verdict.missing) +
         " missing, " + std::to_string(verdict.counted) + " counted as lost, " +
         std::to_string(verdict.repeated) + " repeated, " + std::to_string(verdict.damaged) +
         " damaged, " + std::to_string(verdict.subscriptions) + " subscriptions";
}

}  // namespace faults
