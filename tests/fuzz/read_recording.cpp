#include "read_recording.h"

#include <support/memory_file.h>
#include <tendon/recording/mcap/copy.h>
#include <tendon/recording/mcap/verify.h>

#include <memory>
#include <utility>
#include <vector>

#include "promise.h"

namespace fuzz {
namespace {

namespace mcap = tendon::mcap;

std::unique_ptr<tendon::test::MemoryFile> FileOf(Bytes bytes) {
  return std::make_unique<tendon::test::MemoryFile>(
      std::vector<std::byte>(bytes.begin(), bytes.end()));
}

struct Found {
  std::size_t count = 0;
  bool is_in_order = true;
  bool is_complete = true;
};

Found ReadMessages(mcap::Reader& reader, mcap::Query::Order order) {
  Found found;
  mcap::Timestamp last = 0;
  unsigned sum = 0;
  auto messages = reader.Messages({.order = order});
  while (const auto message = messages.Next()) {
    ++found.count;
    found.is_in_order = found.is_in_order && message->log_time >= last;
    last = message->log_time;
    for (const std::byte byte : message->data) sum += std::to_integer<unsigned>(byte);
    Require(reader.FindChannel(message->channel_id) != nullptr, "a message has a channel");
  }
  static_cast<void>(sum);  // a sanitizer checks each byte that was read
  found.is_complete = messages.is_complete();
  return found;
}

void Recover(mcap::Reader& reader, std::size_t count) {
  const auto disk = std::make_shared<tendon::test::MemoryDisk>();
  auto writer = mcap::Writer::Create(std::make_unique<tendon::test::MemoryWritableFile>(disk),
                                     {.chunk_size = 4096});
  const auto report = mcap::Copy(reader, {.order = mcap::Query::Order::kFile}, **writer);
  Require(report.ok(), "what was read can be written");
  Require(report->messages == count, "all messages that are read are recovered");
  Require((*writer)->Close().ok(), "a recovered file is completed");
  auto again = mcap::Reader::Open(FileOf(disk->bytes));
  Require(again && !(*again)->was_scanned(), "a recovered file has an index");
  Require(tendon::mcap::Verify(**again).problems.count() == 0, "a recovered file is whole");
  Require(ReadMessages(**again, mcap::Query::Order::kLogTime).count == count,
          "a recovered file has the same messages");
}

}  // namespace

void ReadRecording(Bytes bytes) {
  auto reader = mcap::Reader::Open(FileOf(bytes), kSmallLimits);
  if (!reader) return;
  const Found by_time = ReadMessages(**reader, mcap::Query::Order::kLogTime);
  const Found by_place = ReadMessages(**reader, mcap::Query::Order::kFile);
  Require(by_time.count == by_place.count || (*reader)->problems().count() > 0,
          "both orders have the same messages");
  Require(by_time.is_in_order || (*reader)->problems().count() > 0,
          "messages are in order, or a problem says that they are not");
  Require(by_time.is_complete || (*reader)->problems().count() > 0, "a loss is told");
  for (const mcap::AttachmentIndex& index : (*reader)->attachments()) {
    (void)(*reader)->ReadAttachment(index);
  }
  for (const mcap::MetadataIndex& index : (*reader)->metadata()) {
    (void)(*reader)->ReadMetadata(index);
  }
  (void)tendon::mcap::Verify(**reader);

  auto scanned = mcap::Reader::OpenByScan(FileOf(bytes), kSmallLimits);
  Require(scanned.ok(), "what opens also opens by a scan");
  const Found all = ReadMessages(**scanned, mcap::Query::Order::kFile);
  Recover(**scanned, all.count);
}

}  // namespace fuzz
