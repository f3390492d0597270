#include <tendon/recording/mcap/writer.h>

#include <tendon/recording/mcap/log_time_text.h>

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>
#include <utility>

namespace tendon::mcap {
namespace {

constexpr std::size_t kSmallestChunk = std::size_t{4} << 10U;
constexpr std::size_t kLargestChunk = std::size_t{64} << 20U;
constexpr std::size_t kMaxIds = 65'535;
constexpr std::size_t kMessageIndexEntrySize = 16;                      // bytes in the file
constexpr std::size_t kMessageIndexHeadSize = kRecordHeadSize + 2 + 4;  // channel, size of list
constexpr std::size_t kChunkIndexHeadSize = kRecordHeadSize + 72;       // without its lists
constexpr std::size_t kChunkIndexEntrySize = 10;

std::uint64_t SizeOf(std::span<const ByteView> parts) {
  return std::accumulate(parts.begin(), parts.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const ByteView& part) { return sum + part.size(); });
}

Error Invalid(std::string message) { return {ErrorCode::kInvalid, std::move(message)}; }

WriterOptions Limited(WriterOptions options) {
  options.chunk_size = std::clamp(options.chunk_size, kSmallestChunk, kLargestChunk);
  return options;
}

std::size_t SizeOf(const std::map<std::string, std::string>& map) {
  std::size_t size = 0;
  for (const auto& [key, value] : map) size += key.size() + value.size() + 8;
  return size;
}

void AppendBytes(Buffer& out, ByteView bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

/// "12 messages up to 2025-11-21 15:40:03.250"
std::string MessagesText(const Progress& progress) {
  std::string text = std::to_string(progress.messages) + " messages";
  if (progress.messages > 0) text += " up to " + LogTimeText(progress.last_log_time);
  return text;
}

}  // namespace

Error FileExistsError(const std::filesystem::path& file) {
  const auto existing = os::OpenRandomAccessFile(file);
  const bool is_being_written = existing && (*existing)->is_being_written();
  return {ErrorCode::kExists,
          file.string() + (is_being_written
                               ? " is being recorded: choose another name, or "
                                 "stop that recording first"
                               : " already exists, and a recording never replaces a file, because "
                                 "another program may still be writing it: choose another name")};
}

Writer::Writer(std::unique_ptr<os::WritableFile> file, const WriterOptions& options)
    : file_(std::move(file)),
      options_(Limited(options)),
      compressor_(options.compression, options.level) {
  chunk_.reserve(options_.chunk_size);
}

Writer::~Writer() { static_cast<void>(Close()); }

/// Converts exceptions to an error; they occur only if memory is exhausted. After that, the file is
/// not continued, because a chunk may be incomplete.
template <typename Call>
auto Writer::Guarded(const Call& call) -> decltype(call()) {
  if (failure_) return *failure_;
  try {
    return call();
  } catch (const std::exception& thrown) {
    failure_ = Failure({ErrorCode::kFailed, thrown.what()});
    return *failure_;
  }
}

Result<std::unique_ptr<Writer>> Writer::Create(const std::filesystem::path& file,
                                               const WriterOptions& options) {
  auto made = os::CreateWritableFile(file);
  if (!made && made.error().code == ErrorCode::kExists) return FileExistsError(file);
  if (!made) return made.error();
  return Create(*std::move(made), options);
}

Result<std::unique_ptr<Writer>> Writer::Create(std::unique_ptr<os::WritableFile> file,
                                               const WriterOptions& options) {
  try {
    std::unique_ptr<Writer> writer(new Writer(std::move(file), options));
    if (auto begun = writer->Begin(); !begun) return begun.error();
    return writer;
  } catch (const std::exception& thrown) {
    return Error{ErrorCode::kFailed, std::string("cannot begin a recording: ") + thrown.what()};
  }
}

Result<void> Writer::Begin() {
  AppendBytes(head_, Magic());
  Append(head_, Header{options_.profile, options_.library});
  return WriteRecords(std::array{ByteView(head_)}, Crc32(head_));
}

Result<void> Writer::CheckOpen() const {
  if (!closed_) return {};
  return Invalid("cannot write to " + file_->name() + ": the file is closed; create another file");
}

Result<SchemaId> Writer::AddSchema(const std::string& name, const std::string& encoding,
                                   const std::string& data) {
  return Guarded([&]() -> Result<SchemaId> {
    if (auto open = CheckOpen(); !open) return open.error();
    const std::size_t size = name.size() + encoding.size() + data.size();
    if (size > kLargestText) {
      return Invalid("schema '" + name.substr(0, 100) + "' has " + std::to_string(size) +
                     " bytes, more than " + std::to_string(kLargestText));
    }
    if (schemas_.size() == kMaxIds) {
      return Invalid("cannot add schema '" + name +
                     "': a file has at most 65,535 schemas; begin another file");
    }
    if (auto room = MakeRoom(size); !room) return room.error();
    schemas_.push_back({static_cast<SchemaId>(schemas_.size() + 1), name, encoding, data});
    Append(chunk_, schemas_.back());
    text_size_ += kRecordHeadSize + size + 14;
    return schemas_.back().id;
  });
}

Result<ChannelId> Writer::AddChannel(SchemaId schema, const std::string& topic,
                                     const std::string& message_encoding,
                                     const std::map<std::string, std::string>& metadata) {
  return Guarded([&]() -> Result<ChannelId> {
    if (auto open = CheckOpen(); !open) return open.error();
    const std::size_t size = topic.size() + message_encoding.size() + SizeOf(metadata);
    if (size > kLargestText) {
      return Invalid("the texts of channel '" + topic.substr(0, 100) + "' have " +
                     std::to_string(size) + " bytes, more than " + std::to_string(kLargestText));
    }
    if (schema > schemas_.size()) {
      return Invalid("cannot add channel '" + topic + "': schema " + std::to_string(schema) +
                     " is unknown; add this schema first");
    }
    if (channels_.size() == kMaxIds) {
      return Invalid("cannot add channel '" + topic +
                     "': a file has at most 65,535 channels; begin another file");
    }
    if (auto room = MakeRoom(size); !room) return room.error();
    ChannelState state;
    state.channel = {static_cast<ChannelId>(channels_.size() + 1), schema, topic, message_encoding,
                     metadata};
    Append(chunk_, state.channel);
    channels_.push_back(std::move(state));
    text_size_ += kRecordHeadSize + size + 16;
    return channels_.back().channel.id;
  });
}

Result<void> Writer::Write(const Message& message) {
  return Guarded([&] { return AddMessage(message); });
}

Result<void> Writer::AddMessage(const Message& message) {
  if (auto open = CheckOpen(); !open) return open;
  const std::size_t index = std::size_t{message.channel_id} - 1;
  if (index >= channels_.size()) {
    return Invalid("cannot write a message to " + file_->name() + ": channel " +
                   std::to_string(message.channel_id) + " is unknown; add this channel first");
  }
  if (message.data.size() > kLargestMessage) {
    return Invalid("cannot write a message of " + std::to_string(message.data.size()) +
                   " bytes on " + channels_[index].channel.topic + ": at most " +
                   std::to_string(kLargestMessage) + " are possible");
  }
  const std::size_t size = kRecordHeadSize + kMessageHeadSize + message.data.size();
  if (auto room = MakeRoom(size); !room) return room;
  if (index_size_ > options_.largest_index) {
    return Error{ErrorCode::kFailed,
                 "the index of " + file_->name() + " has " + std::to_string(index_size_) +
                     " bytes, which is the limit: close the file and begin another file"};
  }
  const std::uint64_t offset = chunk_.size();
  Append(chunk_, message);
  if (entries_.empty()) chunk_start_ = chunk_end_ = message.log_time;
  chunk_start_ = std::min(chunk_start_, message.log_time);
  chunk_end_ = std::max(chunk_end_, message.log_time);
  entries_.push_back({message.channel_id, {message.log_time, offset}});
  if (channels_[index].in_chunk++ == 0) used_.push_back(message.channel_id);
  ++accepted_.messages;
  accepted_.last_log_time = std::max(accepted_.last_log_time, message.log_time);
  return {};
}

Result<void> Writer::Write(const Attachment& attachment) {
  return Guarded([&]() -> Result<void> {
    if (auto open = CheckOpen(); !open) return open;
    const std::size_t size = attachment.name.size() + attachment.media_type.size();
    if (size > kLargestText) {
      return Invalid("the name of an attachment has " + std::to_string(size) +
                     " bytes, more than " + std::to_string(kLargestText));
    }
    head_.clear();
    AppendAttachmentHead(head_, attachment);
    const ByteView fields = ByteView(head_).subspan(kRecordHeadSize);
    Buffer tail;
    AppendNumber(tail, Crc32(attachment.data, Crc32(fields)), 4);
    const std::array<ByteView, 3> parts{head_, attachment.data, tail};
    const AttachmentIndex index{end_,
                                SizeOf(parts),
                                attachment.log_time,
                                attachment.create_time,
                                attachment.data.size(),
                                attachment.name,
                                attachment.media_type};
    attachments_.reserve(attachments_.size() + 1);
    const std::uint32_t crc = Crc32(tail, Crc32(attachment.data, Crc32(head_)));
    if (auto written = WriteRecords(parts, crc); !written) return written;
    attachments_.push_back(index);
    index_size_ += sizeof(index) + size;
    return {};
  });
}

Result<void> Writer::Write(const Metadata& metadata) {
  return Guarded([&]() -> Result<void> {
    if (auto open = CheckOpen(); !open) return open;
    const std::size_t size = metadata.name.size() + SizeOf(metadata.metadata);
    if (size > kLargestText) {
      return Invalid("metadata '" + metadata.name.substr(0, 100) + "' has " + std::to_string(size) +
                     " bytes, more than " + std::to_string(kLargestText) +
                     ": write an attachment instead");
    }
    head_.clear();
    Append(head_, metadata);
    const MetadataIndex index{end_, head_.size(), metadata.name};
    if (auto written = WriteRecords(std::array{ByteView(head_)}, Crc32(head_)); !written) {
      return written;
    }
    metadata_.push_back(index);
    index_size_ += sizeof(index) + metadata.name.size();
    return {};
  });
}

/// Writes the present chunk if a record of `size` bytes would make it too large. A chunk without
/// messages has no time, which confuses other programs. Therefore, such a chunk is written only
/// when it has reached the maximum size.
Result<void> Writer::MakeRoom(std::size_t size) {
  const std::size_t most = entries_.empty() ? kLargestChunk : options_.chunk_size;
  if (!chunk_.empty() && chunk_.size() + size > most) {
    if (auto written = WriteChunk(); !written) return written;
  }
  BeginChunk();
  return {};
}

/// Repeats definitions, up to the size of a chunk: the definitions that only one chunk contains,
/// and all definitions if the file has grown by much more than their size.
void Writer::BeginChunk() {
  constexpr std::uint64_t kGrowth = 64;
  if (!chunk_.empty()) return;
  if (end_ >= next_repeat_) {
    repeated_schemas_ = repeated_channels_ = 0;
    next_repeat_ = end_ + kGrowth * std::max(options_.chunk_size, text_size_);
  }
  while (repeated_schemas_ < schemas_.size() && chunk_.size() < options_.chunk_size) {
    Append(chunk_, schemas_[repeated_schemas_++]);
  }
  while (repeated_channels_ < channels_.size() && chunk_.size() < options_.chunk_size) {
    Append(chunk_, channels_[repeated_channels_++].channel);
  }
}

Result<void> Writer::WriteChunk() {
  if (chunk_.empty()) return {};
  Compression used = Compression::kNone;
  const auto records = compressor_.Compress(chunk_, used);
  if (!records) {
    failure_ = Failure(records.error());
    return *failure_;
  }
  const std::uint32_t chunk_crc = Crc32(chunk_);
  const ChunkHead chunk{
      chunk_start_,   chunk_end_, chunk_.size(), chunk_crc, std::string(FormatNameOf(used)),
      records->size()};
  head_.clear();
  AppendChunkHead(head_, chunk);
  ChunkIndex index{.message_start_time = chunk.message_start_time,
                   .message_end_time = chunk.message_end_time,
                   .chunk_start_offset = end_,
                   .chunk_length = head_.size() + records->size(),
                   .compression = chunk.compression,
                   .compressed_size = records->size(),
                   .uncompressed_size = chunk.uncompressed_size};
  MakeMessageIndexes(index);
  chunks_.reserve(chunks_.size() == chunks_.capacity() ? 2 * chunks_.size() + 1 : chunks_.size());

  const std::uint32_t records_crc = used == Compression::kNone ? chunk_crc : Crc32(*records);
  std::uint32_t crc = CombinedCrc32(Crc32(head_), records_crc, records->size());
  crc = CombinedCrc32(crc, Crc32(index_), index_.size());
  const std::array<ByteView, 3> parts{head_, *records, index_};
  if (auto written = WriteRecords(parts, crc); !written) return written;
  CountChunk(std::move(index));
  return {};
}

/// Makes the message index records in index_ with one pass over the messages. Each record has its
/// own range in index_.
void Writer::MakeMessageIndexes(ChunkIndex& index) {
  std::sort(used_.begin(), used_.end());
  index_.clear();
  index.message_index_offsets.reserve(used_.size());
  const std::uint64_t begin = index.chunk_start_offset + index.chunk_length;
  for (const ChannelId id : used_) {
    ChannelState& state = channels_[std::size_t{id} - 1];
    index.message_index_offsets.emplace_back(id, begin + index_.size());
    const std::size_t list = state.in_chunk * kMessageIndexEntrySize;
    AppendNumber(index_, static_cast<std::uint64_t>(Opcode::kMessageIndex), 1);
    AppendNumber(index_, kMessageIndexHeadSize - kRecordHeadSize + list, 8);
    AppendNumber(index_, id, 2);
    AppendNumber(index_, list, 4);
    state.index_place = index_.size();
    index_.resize(index_.size() + list);
  }
  for (const ChunkEntry& entry : entries_) {
    std::size_t& place = channels_[std::size_t{entry.channel} - 1].index_place;
    PutNumber(index_.data() + place, entry.entry.log_time);
    PutNumber(index_.data() + place + 8, entry.entry.offset);
    place += kMessageIndexEntrySize;
  }
  index.message_index_length = index_.size();
}

void Writer::CountChunk(ChunkIndex index) {
  if (!entries_.empty()) {
    const bool is_first = written_.messages == 0;
    first_time_ = is_first ? chunk_start_ : std::min(first_time_, chunk_start_);
    last_time_ = is_first ? chunk_end_ : std::max(last_time_, chunk_end_);
  }
  written_.messages += entries_.size();
  written_.last_log_time = last_time_;
  for (const ChannelId id : used_) {
    ChannelState& state = channels_[std::size_t{id} - 1];
    state.messages += std::exchange(state.in_chunk, 0);
  }
  index_size_ += sizeof(index) + used_.size() * sizeof(index.message_index_offsets.front());
  chunks_.push_back(std::move(index));
  used_.clear();
  entries_.clear();
  chunk_.clear();
  chunk_start_ = chunk_end_ = 0;
  if (chunk_.capacity() > 2 * options_.chunk_size) {  // after a message that is larger
    chunk_.shrink_to_fit();
    chunk_.reserve(options_.chunk_size);
  }
}

/// `crc` is the checksum of all parts.
Result<void> Writer::WriteRecords(std::span<const ByteView> parts, std::uint32_t crc) {
  const std::uint64_t size = SizeOf(parts);
  auto done = file_->Reserve(end_, size + SummarySize());
  if (done) done = file_->WriteAt(end_, parts);
  if (!done) {
    failure_ = Failure(done.error());
    return *failure_;
  }
  crc_ = CombinedCrc32(crc_, crc, size);
  end_ += size;
  written_.bytes = end_;
  accepted_.bytes = end_;
  return {};
}

Error Writer::Failure(const Error& reason) const {
  return {ErrorCode::kFailed,
          "recording stopped: cannot write at " + std::to_string(end_) + " of " + file_->name() +
              ": " + reason.message + "; " + MessagesText(written_) + " are in the file; the " +
              std::to_string(accepted_.messages - written_.messages) +
              " later messages are lost; free space or check the disk, then record into another "
              "file"};
}

/// After a failed sync, the operating system may have dropped everything since the last sync.
Error Writer::SyncFailure(const Error& reason) const {
  return {ErrorCode::kFailed,
          "recording stopped: cannot write " + file_->name() + " to the disk: " + reason.message +
              "; " + MessagesText(synced_) + " are on the disk; the " +
              std::to_string(accepted_.messages - synced_.messages) +
              " later messages may be lost; check the disk, then record into another file"};
}

Result<void> Writer::Sync() {
  return Guarded([&]() -> Result<void> {
    if (auto open = CheckOpen(); !open) return open;
    if (auto written = WriteChunk(); !written) return written;
    if (synced_ == written_) return {};
    if (auto done = file_->Sync(); !done) {
      failure_ = SyncFailure(done.error());
      return *failure_;
    }
    synced_ = written_;
    return {};
  });
}

Result<void> Writer::Flush() {
  return Guarded([&]() -> Result<void> {
    if (auto open = CheckOpen(); !open) return open;
    return WriteChunk();
  });
}

Result<void> Writer::Close(std::span<const Metadata> last) {
  if (closed_) return *closed_;
  try {
    if (!failure_) static_cast<void>(Guarded([&] { return WriteChunk(); }));
    WriteLast(last);
    auto summary = WriteSummary();
    if (summary) {
      if (!failure_) synced_ = written_;
    } else {
      static_cast<void>(file_->Truncate(end_));
    }
    if (failure_ && !summary) {
      failure_->message += "; the file has no index; to make an index: gcm recover";
    }
    closed_ = failure_ ? Result<void>(*failure_) : summary;
  } catch (const std::exception& thrown) {
    closed_ =
        Error{ErrorCode::kFailed, std::string("cannot complete a recording: ") + thrown.what()};
  }
  return *closed_;
}

/// Writes metadata, even after a failed write, because space is reserved for them. Metadata that
/// cannot be written are left out of the summary.
void Writer::WriteLast(std::span<const Metadata> last) {
  std::size_t size = 0;
  for (const Metadata& metadata : last) {
    head_.clear();
    Append(head_, metadata);
    size += head_.size();
    const bool has_room = !failure_ && file_->Reserve(end_, head_.size() + SummarySize());
    if (!has_room && size > kLastMetadata) return;
    if (!file_->WriteAt(end_, std::array{ByteView(head_)})) return;
    metadata_.push_back({end_, head_.size(), metadata.name});
    crc_ = CombinedCrc32(crc_, Crc32(head_), head_.size());
    end_ += head_.size();
  }
}

Result<void> Writer::WriteSummary() {
  Buffer out;
  Append(out, DataEnd{crc_});
  const Buffer summary = Summary(end_ + out.size());
  AppendBytes(out, summary);
  const std::uint64_t size = end_ + out.size();
  auto done = file_->WriteAt(end_, std::array{ByteView(out)});
  if (done) done = file_->Truncate(size);  // parts of a failed chunk may be after it
  if (done) done = file_->Sync();
  if (done) {
    written_.bytes = accepted_.bytes = size;
    return {};
  }
  return Error{ErrorCode::kFailed, "cannot write the index of " + file_->name() + ": " +
                                       done.error().message + "; " +
                                       std::to_string(written_.messages) +
                                       " messages are in the file; to make an index: gcm recover"};
}

/// Returns the bytes from the first record of the summary to the end of the file. `start` is the
/// offset of this record.
Buffer Writer::Summary(std::uint64_t start) const {
  Buffer out;
  out.reserve(SummarySize());
  std::vector<SummaryOffset> groups;
  std::size_t begin = 0;
  const auto end_group = [&](Opcode opcode) {
    if (out.size() == begin) return;
    groups.push_back({static_cast<std::uint8_t>(opcode), start + begin, out.size() - begin});
    begin = out.size();
  };
  for (const Schema& schema : schemas_) Append(out, schema);
  end_group(Opcode::kSchema);
  for (const ChannelState& state : channels_) Append(out, state.channel);
  end_group(Opcode::kChannel);
  Append(out, MakeStatistics());
  end_group(Opcode::kStatistics);
  for (const ChunkIndex& index : chunks_) Append(out, index);
  end_group(Opcode::kChunkIndex);
  for (const AttachmentIndex& index : attachments_) Append(out, index);
  end_group(Opcode::kAttachmentIndex);
  for (const MetadataIndex& index : metadata_) Append(out, index);
  end_group(Opcode::kMetadataIndex);

  Footer footer{start, start + out.size(), 0};
  for (const SummaryOffset& group : groups) Append(out, group);
  Append(out, footer);
  constexpr std::size_t kCrcSize = 4;
  out.resize(out.size() - kCrcSize);
  AppendNumber(out, Crc32(out), kCrcSize);
  AppendBytes(out, Magic());
  return out;
}

Statistics Writer::MakeStatistics() const {
  Statistics statistics{.message_count = written_.messages,
                        .schema_count = static_cast<std::uint16_t>(schemas_.size()),
                        .channel_count = static_cast<std::uint32_t>(channels_.size()),
                        .attachment_count = static_cast<std::uint32_t>(attachments_.size()),
                        .metadata_count = static_cast<std::uint32_t>(metadata_.size()),
                        .chunk_count = static_cast<std::uint32_t>(chunks_.size()),
                        .message_start_time = first_time_,
                        .message_end_time = last_time_};
  for (const ChannelState& state : channels_) {
    if (state.messages > 0) {
      statistics.channel_message_counts.emplace(state.channel.id, state.messages);
    }
  }
  return statistics;
}

/// Returns the size of the summary after one more chunk, or a larger number.
std::uint64_t Writer::SummarySize() const {
  constexpr std::size_t kStatistics = 128;
  constexpr std::size_t kOffsets = 6 * (kRecordHeadSize + 17);
  std::size_t size = kDataEndSize + text_size_ + kStatistics + kOffsets + kFooterSize + kMagicSize;
  size += (chunks_.size() + 1) * (kChunkIndexHeadSize + 4);
  size += index_size_;  // an upper limit for the lists and texts of the chunks
  size += channels_.size() * 2 * kChunkIndexEntrySize;
  size += 2 * kLastMetadata;  // with their index
  return size;
}

}  // namespace tendon::mcap
