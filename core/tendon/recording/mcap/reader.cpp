#include <tendon/recording/mcap/reader.h>

#include <tendon/base/text.h>
#include <tendon/recording/mcap/compression.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace tendon::mcap {
namespace {

/// "the chunk at 1234 is skipped: the checksum of the chunk is wrong"
std::string SkippedText(const MessageBlock& block, const Error& reason) {
  return std::string(block.is_chunk ? "the chunk" : "the block of messages") + " at " +
         std::to_string(block.index.chunk_start_offset) + " is skipped: " + reason.message;
}

Error Unreadable(std::string what, std::string reason) {
  return {ErrorCode::kInvalid, "cannot read " + std::move(what) + ": " + std::move(reason)};
}

std::string_view TextOf(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Reader::Reader(std::unique_ptr<os::RandomAccessFile> file, const ReaderLimits& limits)
    : file_(std::move(file)), limits_(limits), buffered_(*file_), exact_(*file_, 0) {}

Reader::~Reader() = default;

Result<std::unique_ptr<Reader>> Reader::Open(const std::filesystem::path& file,
                                             const ReaderLimits& limits) {
  auto opened = os::OpenRandomAccessFile(file);
  if (!opened) return opened.error();
  return Make(*std::move(opened), limits, false);
}

Result<std::unique_ptr<Reader>> Reader::Open(std::unique_ptr<os::RandomAccessFile> file,
                                             const ReaderLimits& limits) {
  return Make(std::move(file), limits, false);
}

Result<std::unique_ptr<Reader>> Reader::OpenByScan(std::unique_ptr<os::RandomAccessFile> file,
                                                   const ReaderLimits& limits) {
  return Make(std::move(file), limits, true);
}

Result<std::unique_ptr<Reader>> Reader::Make(std::unique_ptr<os::RandomAccessFile> file,
                                             const ReaderLimits& limits, bool by_scan) {
  try {
    std::unique_ptr<Reader> reader(new Reader(std::move(file), limits));
    if (auto checked = reader->CheckMagic(); !checked) return checked.error();
    reader->ReadContents(by_scan);
    return reader;
  } catch (const std::exception& thrown) {
    return Error{ErrorCode::kFailed, std::string("cannot read a recording: ") + thrown.what()};
  }
}

Result<void> Reader::CheckMagic() {
  const auto begin = buffered_.UpTo(0, kMagicSize);
  if (!begin) return begin.error();
  if (std::ranges::equal(*begin, Magic())) return {};
  const std::string what = file_->name() + " is not a recording: ";
  if (begin->empty()) return Error{ErrorCode::kInvalid, what + "it is empty"};
  if (std::ranges::equal(*begin, Magic().first(begin->size()))) {
    return Error{ErrorCode::kInvalid,
                 what + "the file ends after " + std::to_string(begin->size()) + " bytes"};
  }
  constexpr std::size_t kBeforeVersion = 5;
  const std::string_view text = TextOf(*begin);
  if (std::ranges::equal(begin->first(std::min(kBeforeVersion, begin->size())),
                         Magic().first(kBeforeVersion)) &&
      text.size() > kBeforeVersion && text[kBeforeVersion] != '0') {
    return Error{ErrorCode::kInvalid, what + "the file has version " +
                                          Quoted(text.substr(kBeforeVersion, 1)) +
                                          " of MCAP, but this program reads version 0"};
  }
  std::string guess;
  if (text.starts_with("PK")) guess = "; it may be a ZIP archive";
  if (text.starts_with("#ROSBAG")) guess = "; it may be a ROS 1 bag";
  if (text.starts_with("SQLite")) guess = "; it may be a ROS 2 bag in SQLite";
  return Error{ErrorCode::kInvalid, what + "the file begins with " + Quoted(text) +
                                        ", but an MCAP file begins with '\\x89MCAP0'" + guess};
}

void Reader::ReadContents(bool by_scan) {
  std::optional<Contents> summary;
  if (!by_scan) summary = ReadSummary(buffered_, limits_, problems_);
  was_scanned_ = !summary;
  if (summary) {
    contents_ = *std::move(summary);
    ReadHeader(buffered_, contents_, problems_);
  } else {
    contents_ = Scan(buffered_, limits_, problems_);
  }
}

const Channel* Reader::FindChannel(ChannelId id) const {
  const auto found = contents_.channels.find(id);
  return found == contents_.channels.end() ? nullptr : &found->second;
}

MessageStream Reader::Messages(Query query) { return {*this, std::move(query)}; }

/// Returns the records of a block, from the cache or from the file. Null if they are lost.
std::shared_ptr<const RawBuffer> Reader::Load(const MessageBlock& block) {
  if (!cache_.empty() && cache_.back().first == &block) return cache_.back().second;
  const auto found =
      std::ranges::find(cache_, &block, [](const auto& entry) { return entry.first; });
  if (found != cache_.end()) {
    std::rotate(found, found + 1, cache_.end());
    return cache_.back().second;
  }
  auto loaded = LoadRecords(block);
  if (!loaded) {
    const std::uint64_t offset = block.index.chunk_start_offset;
    if (lost_blocks_.insert(offset).second) {
      problems_.Add(offset, SkippedText(block, loaded.error()));
    }
    return nullptr;
  }
  auto records = std::make_shared<const RawBuffer>(*std::move(loaded));
  cache_size_ += records->bytes().size();
  cache_.emplace_back(&block, records);
  while (cache_size_ > limits_.cache && cache_.size() > 1) {
    cache_size_ -= cache_.front().second->bytes().size();
    cache_.erase(cache_.begin());
  }
  return records;
}

Result<RawBuffer> Reader::LoadRecords(const MessageBlock& block) {
  const ChunkIndex& index = block.index;
  if (block.is_chunk) {
    const auto place = FindChunk(exact_, index.chunk_start_offset);
    if (!place) return place.error();
    if (auto fits = CheckAgainstIndex(*place, index); !fits) return fits.error();
    auto chunk = LoadChunk(exact_, *place, limits_);
    if (!chunk) return chunk.error();
    return std::move(chunk->records);
  }
  if (index.chunk_length > limits_.chunk + kRecordHeadSize) {
    return Error{ErrorCode::kInvalid, "the block is larger than the limit"};
  }
  RawBuffer records(static_cast<std::size_t>(index.chunk_length));
  if (auto read = file_->ReadAt(index.chunk_start_offset, records.bytes()); !read) {
    return read.error();
  }
  return records;
}

Result<void> Reader::CheckAgainstIndex(const ChunkPlace& place, const ChunkIndex& index) const {
  if (was_scanned_) return {};
  const ChunkHead& head = place.head;
  if (place.length == index.chunk_length && head.records_size == index.compressed_size &&
      head.uncompressed_size == index.uncompressed_size && head.compression == index.compression &&
      head.message_start_time == index.message_start_time &&
      head.message_end_time == index.message_end_time) {
    return {};
  }
  return Error{ErrorCode::kInvalid,
               "the fields of the chunk differ from the index at the end of the file"};
}

/// Returns the content of a record. An index states its place.
Result<Buffer> Reader::ReadRecord(std::uint64_t offset, std::uint64_t length, Opcode opcode,
                                  std::uint64_t most) {
  const auto head = exact_.HeadAt(offset);
  if (!head) return head.error();
  if (head->opcode != opcode || length < kRecordHeadSize ||
      head->length != length - kRecordHeadSize || length > file_->size() - offset) {
    return Error{ErrorCode::kInvalid,
                 "the record at this place is not the record that the index names"};
  }
  if (head->length > most) {
    return Error{ErrorCode::kInvalid, "the record has " + std::to_string(head->length) +
                                          " bytes, more than " + std::to_string(most)};
  }
  Buffer content(static_cast<std::size_t>(head->length));
  if (auto read = file_->ReadAt(offset + kRecordHeadSize, content); !read) return read.error();
  return content;
}

Result<Attachment> Reader::ReadAttachment(const AttachmentIndex& index) try {
  constexpr std::size_t kCrcSize = 4;
  const std::string what = "attachment " + Quoted(index.name, 200) + " at " +
                           std::to_string(index.offset) + " of " + file_->name();
  auto content = ReadRecord(index.offset, index.length, Opcode::kAttachment, limits_.attachment);
  if (!content) return Unreadable(what, content.error().message);
  Attachment attachment;
  std::uint64_t size = 0;
  const auto begin = ParseAttachmentHead(*content, content->size(), attachment, size);
  if (!begin || size != index.data_size)
    return Unreadable(what, "the fields of the record do not match the length of the record");
  const std::size_t end = *begin + static_cast<std::size_t>(size);
  const ByteView bytes(*content);
  std::uint32_t stated = 0;
  for (std::size_t i = 0; i < kCrcSize; ++i) {
    stated |= std::to_integer<std::uint32_t>(bytes[end + i]) << (8 * i);
  }
  const std::uint32_t crc = stated == 0 ? 0 : Crc32(bytes.first(end));
  if (crc != stated) {
    return Unreadable(what, "the checksum of the attachment is " + HexText(crc) + " instead of " +
                                HexText(stated));
  }
  content->resize(end);
  content->erase(content->begin(), content->begin() + static_cast<std::ptrdiff_t>(*begin));
  attachment.data = *std::move(content);
  return attachment;
} catch (const std::exception& thrown) {
  return Error{ErrorCode::kFailed, std::string("cannot read an attachment: ") + thrown.what()};
}

Result<Metadata> Reader::ReadMetadata(const MetadataIndex& index) try {
  const std::string what = "metadata " + Quoted(index.name, 200) + " at " +
                           std::to_string(index.offset) + " of " + file_->name();
  const auto content = ReadRecord(index.offset, index.length, Opcode::kMetadata, limits_.text);
  if (!content) return Unreadable(what, content.error().message);
  Metadata metadata;
  if (Parse(*content, metadata) == ParseResult::kMalformed || metadata.name != index.name) {
    return Unreadable(what, "it is damaged");
  }
  return metadata;
} catch (const std::exception& thrown) {
  return Error{ErrorCode::kFailed, std::string("cannot read metadata: ") + thrown.what()};
}

Result<std::vector<MessageIndex>> Reader::ReadMessageIndexes(const MessageBlock& block) try {
  const ChunkIndex& chunk = block.index;
  const std::uint64_t begin = chunk.chunk_start_offset + chunk.chunk_length;
  const std::string what = "the message indexes of the chunk at " +
                           std::to_string(chunk.chunk_start_offset) + " of " + file_->name();
  std::vector<MessageIndex> indexes;
  if (!block.is_chunk || chunk.message_index_length == 0) return indexes;
  if (chunk.message_index_length > limits_.chunk || begin > file_->size() ||
      chunk.message_index_length > file_->size() - begin) {
    return Unreadable(what, "their length is " + std::to_string(chunk.message_index_length));
  }
  Buffer bytes(static_cast<std::size_t>(chunk.message_index_length));
  if (auto read = file_->ReadAt(begin, bytes); !read) return read.error();
  RecordSequence records(bytes);
  while (const auto record = records.Next()) {
    MessageIndex index;
    if (record->opcode != Opcode::kMessageIndex ||
        Parse(record->content, index) != ParseResult::kExact) {
      return Unreadable(what,
                        "there is no message index at " + std::to_string(begin + record->offset));
    }
    indexes.push_back(std::move(index));
  }
  if (records.is_malformed()) return Unreadable(what, "the last message index is cut off");
  return indexes;
} catch (const std::exception& thrown) {
  return Error{ErrorCode::kFailed, std::string("cannot read message indexes: ") + thrown.what()};
}

MessageStream::MessageStream(Reader& reader, Query query)
    : reader_(&reader), query_(std::move(query)) {}

std::optional<Message> MessageStream::Next() {
  try {
    return FindNext();
  } catch (const std::exception& thrown) {
    // There is no memory, so the following messages could not be returned in order.
    is_complete_ = false;
    heads_ = {};
    next_block_ = blocks_.size();
    return std::nullopt;
  }
}

std::optional<Message> MessageStream::FindNext() {
  if (!std::exchange(is_started_, true)) {
    for (const ChannelId channel : query_.channels) {
      wanted_.resize(std::numeric_limits<ChannelId>::max() + 1);
      wanted_[channel] = true;
    }
    for (const MessageBlock& block : reader_->blocks()) {
      if (Wants(block)) blocks_.push_back(&block);
    }
    if (query_.order == Query::Order::kLogTime) {
      std::ranges::stable_sort(
          blocks_, {}, [](const MessageBlock* block) { return block->index.message_start_time; });
    }
  }
  while (true) {
    OpenBlocks();
    if (heads_.empty()) return std::nullopt;
    Head head = heads_.top();
    heads_.pop();
    Source& source = sources_[head.source];
    const auto message = Fetch(source);
    ++source.next;
    if (source.next < source.entries.size()) {
      if (query_.order == Query::Order::kLogTime) head.time = source.entries[source.next].log_time;
      heads_.push(head);
    } else {
      entries_size_ -= source.entries.size() * sizeof(MessageIndexEntry);
      source.entries = {};
      free_sources_.push_back(head.source);
    }
    if (message) return message;
  }
}

/// Opens all blocks that may contain the next message.
void MessageStream::OpenBlocks() {
  const bool by_time = query_.order == Query::Order::kLogTime;
  while (next_block_ < blocks_.size()) {
    const MessageBlock& block = *blocks_[next_block_];
    const bool may_be_next =
        heads_.empty() || (by_time && block.index.message_start_time <= heads_.top().time);
    if (!may_be_next) return;
    ++next_block_;
    Open(block);
  }
}

void MessageStream::Open(const MessageBlock& block) {
  const auto records = reader_->Load(block);
  if (records == nullptr) {
    is_complete_ = false;
    return;
  }
  Source source{.block = &block};
  Collect(block, records->bytes(), source.entries);
  if (source.entries.empty()) return;
  const std::uint64_t size = source.entries.size() * sizeof(MessageIndexEntry);
  if (entries_size_ + size > reader_->limits_.overlap) {
    is_complete_ = false;
    reader_->problems_.Add(block.index.chunk_start_offset,
                           "so many chunks overlap in time that their messages cannot be read in "
                           "order of time; read the messages in the order of the file");
    next_block_ = blocks_.size();
    return;
  }
  entries_size_ += size;
  if (free_sources_.empty()) {
    free_sources_.push_back(sources_.size());
    sources_.emplace_back();
  }
  const std::size_t place = free_sources_.back();
  free_sources_.pop_back();
  const Timestamp time =
      query_.order == Query::Order::kLogTime ? source.entries.front().log_time : 0;
  sources_[place] = std::move(source);
  heads_.push({time, block.index.chunk_start_offset, place});
}

void MessageStream::Collect(const MessageBlock& block, ByteView bytes,
                            std::vector<MessageIndexEntry>& entries) {
  Problems& problems = reader_->problems_;
  Contents& contents = reader_->contents_;
  const std::uint64_t offset = block.index.chunk_start_offset;
  const std::string where = "the chunk at " + std::to_string(offset);
  bool is_in_time = true;
  std::optional<ChannelId> known;  // the channel of the message before
  RecordSequence records(bytes);
  while (const auto record = records.Next()) {
    Message message;
    if (record->opcode == Opcode::kChannel && !reader_->was_scanned_) {
      Channel channel;
      if (Parse(record->content, channel) == ParseResult::kMalformed) continue;
      AddChannel(contents, std::move(channel), offset, problems);
      continue;
    }
    if (record->opcode != Opcode::kMessage) continue;
    if (Parse(record->content, message) == ParseResult::kMalformed) {
      problems.Add(offset, where + " has a malformed message; this message is skipped");
      is_complete_ = false;
      continue;
    }
    if (message.channel_id != known && !contents.channels.contains(message.channel_id)) {
      is_complete_ = is_complete_ && !Wants(message.channel_id);
      if (reader_->was_scanned_) continue;  // the scan has reported it
      problems.Add(offset, where + " has a message on channel " +
                               std::to_string(message.channel_id) +
                               ", which is not defined; this message is skipped");
      continue;
    }
    known = message.channel_id;
    is_in_time = is_in_time && message.log_time >= block.index.message_start_time &&
                 message.log_time <= block.index.message_end_time;
    if (message.log_time < query_.from || message.log_time > query_.to) continue;
    if (!Wants(message.channel_id)) continue;
    entries.push_back({message.log_time, record->offset});
  }
  if (records.is_malformed()) {
    is_complete_ = false;
    if (!reader_->was_scanned_) {
      problems.Add(offset, where + " has no valid record at byte " +
                               std::to_string(records.offset()) +
                               " of its content; the rest of the content is skipped");
    }
  }
  if (!is_in_time) {
    problems.Add(offset, where +
                             " has messages outside of the time span in the index; messages may "
                             "be missing or out of order");
  }
  if (query_.order == Query::Order::kLogTime) {
    std::ranges::stable_sort(entries, {}, &MessageIndexEntry::log_time);
  }
}

bool MessageStream::Wants(const MessageBlock& block) const {
  const ChunkIndex& index = block.index;
  if (index.message_end_time < query_.from || index.message_start_time > query_.to) return false;
  return index.message_index_offsets.empty() ||
         std::ranges::any_of(index.message_index_offsets,
                             [&](const auto& entry) { return Wants(entry.first); });
}

bool MessageStream::Wants(ChannelId channel) const { return wanted_.empty() || wanted_[channel]; }

std::optional<Message> MessageStream::Fetch(const Source& source) {
  const auto records = reader_->Load(*source.block);
  if (records == nullptr) {  // it could be read before
    is_complete_ = false;
    return std::nullopt;
  }
  const auto offset = static_cast<std::size_t>(source.entries[source.next].offset);
  const ByteView bytes = records->bytes();
  RecordSequence sequence(bytes.subspan(std::min(offset, bytes.size())));
  const auto record = sequence.Next();
  Message message;
  if (record && record->opcode == Opcode::kMessage &&
      Parse(record->content, message) != ParseResult::kMalformed) {
    return message;
  }
  is_complete_ = false;
  return std::nullopt;
}

}  // namespace tendon::mcap
