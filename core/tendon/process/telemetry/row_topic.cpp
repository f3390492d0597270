#include <tendon/process/telemetry/row_topic.h>

namespace tendon {

void RowTopic::Send(RowBatchWriter& batch, std::uint64_t lost, std::uint64_t next_tick) {
  constexpr int kLongestQuiet = 25;  // calls of Send(): half a second
  lost_table_ += lost;
  ++silence_;
  if (batch.rows() == 0 && lost_table_ == 0 && silence_ < kLongestQuiet) return;
  const auto body = batch.Finish(
      {.rows_before = rows_before_, .lost_table = lost_table_, .next_tick = next_tick});
  rows_before_ += batch.rows();  // counted even if refused, so that viewers see the gap
  if (!topic_->Publish(body)) return;
  lost_table_ = 0;
  silence_ = 0;
}

}  // namespace tendon
