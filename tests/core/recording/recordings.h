#pragma once

#include <gtest/gtest.h>
#include <support/memory_file.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/verify.h>
#include <tendon/recording/mcap/writer.h>

#include <compare>
#include <cstdint>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Recordings in memory, and functions to read them.
namespace tendon::mcap {

inline ByteView BytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

/// A message that owns its data.
struct StoredMessage {
  std::string topic;
  std::uint32_t sequence = 0;
  Timestamp log_time = 0;
  Timestamp publish_time = 0;
  std::string data;

  bool operator==(const StoredMessage&) const = default;
  auto operator<=>(const StoredMessage&) const = default;
};

/// Returns the value of a message with the encoding of ROS 2.
template <typename T>
T ValueOf(const StoredMessage& message) {
  constexpr std::string_view kLittleEndian("\0\1\0\0", 4);
  EXPECT_TRUE(message.data.starts_with(kLittleEndian));
  T value{};
  EXPECT_TRUE(Decode(BytesOf(message.data).subspan(kLittleEndian.size()), value));
  return value;
}

inline void PrintTo(const StoredMessage& message, std::ostream* out) {
  *out << message.topic << " " << message.sequence << " at " << message.log_time << " ("
       << message.data.size() << " B)";
}

inline std::vector<StoredMessage> ReadAll(Reader& reader, Query query = {},
                                          bool* is_complete = nullptr) {
  std::vector<StoredMessage> all;
  MessageStream messages = reader.Messages(std::move(query));
  while (const auto message = messages.Next()) {
    const Channel* channel = reader.FindChannel(message->channel_id);
    all.push_back(
        {channel == nullptr ? "?" : channel->topic, message->sequence, message->log_time,
         message->publish_time,
         std::string(reinterpret_cast<const char*>(message->data.data()), message->data.size())});
  }
  if (is_complete != nullptr) *is_complete = messages.is_complete();
  return all;
}

inline std::unique_ptr<Reader> Open(const Buffer& bytes, const ReaderLimits& limits = {}) {
  auto reader = Reader::Open(std::make_unique<test::MemoryFile>(bytes), limits);
  EXPECT_TRUE(reader) << (reader ? "" : reader.error().message);
  return reader ? *std::move(reader) : nullptr;
}

/// A writer that writes to memory.
struct MemoryRecording {
  explicit MemoryRecording(const WriterOptions& options = {}) {
    auto made = Writer::Create(std::make_unique<test::MemoryWritableFile>(disk), options);
    if (made) writer = *std::move(made);
  }

  std::shared_ptr<test::MemoryDisk> disk = std::make_shared<test::MemoryDisk>();
  std::unique_ptr<Writer> writer;
};

/// Returns the texts of all problems, one after another.
inline std::string Sentences(const Reader& reader) {
  std::string all;
  for (const Problem& problem : reader.problems().first()) all += problem.sentence + "\n";
  return all;
}

/// The sentences of everything that Verify() finds; empty for a file that is intact.
inline std::string FlawsOf(Reader& reader) {
  const Verification verification = Verify(reader);
  std::string all;
  for (const Problem& problem : verification.problems.first()) all += problem.sentence + "\n";
  return all;
}

struct SampleShape {
  int messages = 400;
  /// The number of messages in a chunk; 0: a chunk ends at `chunk_size`.
  int messages_in_chunk = 0;
  /// The size of a message in bytes; half of its content cannot be compressed. 0: 40 to 76 bytes
  /// that can be compressed.
  std::size_t message_size = 0;
  std::size_t chunk_size = std::size_t{4} << 10U;  // bytes
};

/// A recording with each kind of record: messages on two channels, and an attachment and metadata
/// between them. `messages` are its messages in order.
struct Sample {
  explicit Sample(Compression compression, int count = 400)
      : Sample(compression, SampleShape{.messages = count}) {}
  Sample(Compression compression, const SampleShape& shape) {
    const int count = shape.messages;
    std::mt19937 random(22);
    const ByteView text = BytesOf("{\"name\": \"demo\"}");
    attachment.data.assign(text.begin(), text.end());
    MemoryRecording recording({.profile = "ros2",
                               .library = "test",
                               .compression = compression,
                               .chunk_size = shape.chunk_size});
    Writer& writer = *recording.writer;
    const SchemaId schema = *writer.AddSchema("arm/msg/Joints", "ros2msg", "float64[7] position\n");
    const std::string topics[] = {"robot/arm/state/Joints", "robot/arm/log"};
    const ChannelId channels[] = {
        *writer.AddChannel(schema, topics[0], "cdr", {{"unit", "rad"}, {"period", "1 ms"}}),
        *writer.AddChannel(0, topics[1], "json")};
    for (int i = 0; i < count; ++i) {
      const auto number = static_cast<std::uint32_t>(i);
      const std::size_t which = i % 5 == 4 ? 1 : 0;
      StoredMessage message{topics[which],
                            number,
                            1'000'000'000ULL + number * 1'000'000ULL,
                            1'000'000'000ULL + number * 1'000'000ULL - 50,
                            {}};
      for (std::size_t byte = 0; byte < shape.message_size; ++byte) {
        const bool is_random = byte < shape.message_size / 2;
        message.data.push_back(static_cast<char>(is_random ? random() : 'a' + byte % 16));
      }
      for (std::uint32_t byte = 0; shape.message_size == 0 && byte < 40 + number % 37; ++byte) {
        message.data.push_back(static_cast<char>(byte % 11 == 0 ? number * 31 + byte : byte));
      }
      EXPECT_TRUE(writer.Write({channels[which], message.sequence, message.log_time,
                                message.publish_time, BytesOf(message.data)}));
      messages.push_back(std::move(message));
      if (shape.messages_in_chunk > 0 && (i + 1) % shape.messages_in_chunk == 0) {
        EXPECT_TRUE(writer.Sync());
      }
      if (i == count / 2) {
        EXPECT_TRUE(writer.Write(attachment));
        EXPECT_TRUE(writer.Write(metadata));
      }
    }
    EXPECT_TRUE(writer.Close());
    bytes = recording.disk->bytes;
  }

  std::vector<StoredMessage> messages;
  Attachment attachment{2'000'000'000, 1'500'000'000, "demo.json", "application/json", {}};
  Metadata metadata{"clock", {{"offset", "12"}, {"source", "ptp"}}};
  Buffer bytes;
};

}  // namespace tendon::mcap
