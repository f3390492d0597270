#include <tendon/recording/row_assembler.h>

#include <tendon/recording/recording_format.h>

#include <utility>

namespace tendon::recording {

std::uint32_t MissingRowsBetween(const std::optional<RowKey>& before, const RowKey& next) {
  if (!before || before->run != next.run) return 0;
  const std::uint32_t step = next.sequence - before->sequence;
  return step >= 1 && step < 1U << 31U ? step - 1 : 0;
}

bool RowAssembler::Accepts(std::size_t column, const RowKey& key) const {
  return is_empty_ || (row_.key == key && !row_.cells[column]);
}

void RowAssembler::Add(std::size_t column, const RowKey& key, const mcap::Message& message) {
  const mcap::ByteView body = BodyOf(message.data);
  Add(column, key, message.publish_time, {body.begin(), body.end()});
}

void RowAssembler::Add(std::size_t column, const RowKey& key, mcap::Timestamp publish_time,
                       mcap::Buffer body) {
  if (std::exchange(is_empty_, false)) {
    row_.key = key;
    row_.publish_time = publish_time;
  }
  row_.cells[column] = std::move(body);
}

AssembledRow RowAssembler::Take() {
  is_empty_ = true;
  Cells empty(row_.cells.size());
  AssembledRow row = std::move(row_);
  row_.cells = std::move(empty);
  return row;
}

}  // namespace tendon::recording
