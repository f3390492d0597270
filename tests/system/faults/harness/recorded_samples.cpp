#include "system/faults/harness/recorded_samples.h"

#include <gtest/gtest.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/recording_format.h>

namespace faults {
namespace {

namespace mcap = tendon::mcap;

/// Calls `use(topic, body)` for each message, in the order of the file.
template <typename Use>
void ForEachMessage(mcap::Reader& reader, Use use) {
  mcap::MessageStream messages = reader.Messages({.order = mcap::Query::Order::kFile});
  while (const auto message = messages.Next()) {
    const mcap::Channel* channel = reader.FindChannel(message->channel_id);
    if (channel == nullptr) continue;
    use(channel->topic, tendon::recording::BodyOf(message->data));
  }
  EXPECT_TRUE(messages.is_complete());
}

std::uint64_t NumberOf(mcap::ByteView body) {
  Numbered sample;
  EXPECT_TRUE(tendon::Decode(body, sample));
  EXPECT_TRUE(IsWhole(sample)) << sample.number;
  return sample.number;
}

}  // namespace

void NewestNumber::OnRows(const tendon::RowBatch& batch) {
  Numbered sample;
  if (batch.count == 0 || !tendon::Decode(batch.cell(batch.count - 1, 0), sample)) return;
  const std::scoped_lock lock(mutex_);
  number_ = sample.number;
}

/// The file reports a loss before the rows of a batch, but the loss may be in the middle of the
/// batch. Therefore, the sums are compared.
std::vector<std::uint64_t> NumbersIn(mcap::Reader& reader, const std::string& table, Gaps gaps) {
  std::vector<std::uint64_t> numbers;
  std::uint64_t reported = 0;
  std::uint64_t missing = 0;
  ForEachMessage(reader, [&](const std::string& topic, mcap::ByteView body) {
    if (topic == tendon::recording::kLossTopic) {
      tendon::recording::Loss loss;
      EXPECT_TRUE(tendon::Decode(body, loss));
      if (loss.path == table) reported += loss.table + loss.network + loss.recorder;
    }
    if (topic != table + "/Sample") return;
    const std::uint64_t number = NumberOf(body);
    if (!numbers.empty()) {
      EXPECT_GT(number, numbers.back());
      missing += number - numbers.back() - 1;
      EXPECT_LE(missing, gaps == Gaps::kNone ? 0 : reported) << "before " << number;
    }
    numbers.push_back(number);
  });
  return numbers;
}

std::vector<std::uint64_t> EventsIn(mcap::Reader& reader, const std::string& topic) {
  std::vector<std::uint64_t> numbers;
  ForEachMessage(reader, [&](const std::string& name, mcap::ByteView body) {
    if (name == topic) numbers.push_back(NumberOf(body));
  });
  return numbers;
}

std::vector<std::string> LogIn(mcap::Reader& reader, const std::string& component) {
  std::vector<std::string> texts;
  ForEachMessage(reader, [&](const std::string& topic, mcap::ByteView body) {
    if (topic != tendon::recording::kLogTopic) return;
    tendon::recording::RosLog record;
    EXPECT_TRUE(tendon::Decode(body, record));
    if (record.name == component) texts.push_back(record.msg);
  });
  return texts;
}

}  // namespace faults
