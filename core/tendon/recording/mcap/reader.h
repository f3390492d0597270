#pragma once

#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/mcap/chunk.h>
#include <tendon/recording/mcap/contents.h>
#include <tendon/recording/mcap/records.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <vector>

namespace tendon::mcap {

class MessageStream;

/// Which messages to read, and in which order.
struct Query {
  enum class Order {
    kLogTime,  ///< by log time, then by place in the file
    kFile,     ///< as written
  };

  Timestamp from = kFirstTime;
  Timestamp to = kLastTime;         ///< inclusive
  std::vector<ChannelId> channels;  ///< empty: all
  Order order = Order::kLogTime;
};

/// Reads an MCAP file, also one that is damaged, cut off, or still being written.
///
///     const auto reader = Reader::Open("run.mcap");
///     auto messages = (*reader)->Messages({.from = start, .to = end});
///     while (const auto message = messages.Next()) Use(*message);
///     for (const Problem& problem : (*reader)->problems().first()) Warn(problem.sentence);
///
/// Open() reads the header, the footer and the summary, however large the file is. If the summary
/// is missing, damaged or incomplete, it reads the whole file once. Nothing is read wrong in
/// silence: what a checksum, a length or an index contradicts is skipped, and a Problem says so.
/// The message indexes in the file have no checksum, so messages are found by the index of chunks
/// in the summary, which has one, and by the records of each chunk, which have one.
///
/// Memory: the summary, and the limits in ReaderLimits. No function throws.
///
/// Thread safety: one thread at a time, for a reader with all its streams. Several readers of one
/// file are independent.
class Reader {
 public:
  /// kNotFound or kFailed if the file cannot be opened; kInvalid if it is no MCAP file of version
  /// 0, with what it begins with.
  static Result<std::unique_ptr<Reader>> Open(const std::filesystem::path& file,
                                              const ReaderLimits& limits = {});
  static Result<std::unique_ptr<Reader>> Open(std::unique_ptr<os::RandomAccessFile> file,
                                              const ReaderLimits& limits = {});
  /// Ignores the summary and reads the whole file, as Recover() does.
  static Result<std::unique_ptr<Reader>> OpenByScan(std::unique_ptr<os::RandomAccessFile> file,
                                                    const ReaderLimits& limits = {});
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader();

  [[nodiscard]] const std::string& name() const { return file_->name(); }
  [[nodiscard]] const Header& header() const { return contents_.header; }
  [[nodiscard]] const std::map<SchemaId, Schema>& schemas() const { return contents_.schemas; }
  [[nodiscard]] const std::map<ChannelId, Channel>& channels() const { return contents_.channels; }
  /// Null if there is none.
  [[nodiscard]] const Channel* FindChannel(ChannelId id) const;
  /// Empty only if the summary has none. After a scan, of what was found.
  [[nodiscard]] const std::optional<Statistics>& statistics() const { return contents_.statistics; }
  /// By their place in the file.
  [[nodiscard]] const std::vector<MessageBlock>& blocks() const { return contents_.blocks; }
  [[nodiscard]] const std::vector<AttachmentIndex>& attachments() const {
    return contents_.attachments;
  }
  [[nodiscard]] const std::vector<MetadataIndex>& metadata() const { return contents_.metadata; }
  /// True if another program still writes the file.
  [[nodiscard]] bool is_being_written() const { return file_->is_being_written(); }
  /// True if the summary could not be used, or was not.
  [[nodiscard]] bool was_scanned() const { return was_scanned_; }
  /// What is damaged or missing, as far as it was read; it grows while messages are read.
  [[nodiscard]] const Problems& problems() const { return problems_; }
  /// Records of kinds that this version does not know, which were skipped.
  [[nodiscard]] std::uint64_t unknown_records() const { return contents_.unknown_records; }

  /// The messages that match. The reader must outlive the stream. Costs nothing until Next().
  [[nodiscard]] MessageStream Messages(Query query = {});

  /// kInvalid if the attachment is damaged or above the limit; kFailed if the disk reports an
  /// error.
  Result<Attachment> ReadAttachment(const AttachmentIndex& index);
  /// As ReadAttachment(). Metadata have no checksum of their own: only Verify() sees a wrong byte.
  Result<Metadata> ReadMetadata(const MetadataIndex& index);
  /// The message indexes behind a chunk, as they are in the file; kInvalid if they are damaged.
  Result<std::vector<MessageIndex>> ReadMessageIndexes(const MessageBlock& block);

 private:
  friend class MessageStream;
  friend class Verifier;

  Reader(std::unique_ptr<os::RandomAccessFile> file, const ReaderLimits& limits);

  static Result<std::unique_ptr<Reader>> Make(std::unique_ptr<os::RandomAccessFile> file,
                                              const ReaderLimits& limits, bool by_scan);
  Result<void> CheckMagic();
  void ReadContents(bool by_scan);
  std::shared_ptr<const RawBuffer> Load(const MessageBlock& block);
  Result<RawBuffer> LoadRecords(const MessageBlock& block);
  Result<void> CheckAgainstIndex(const ChunkPlace& place, const ChunkIndex& index) const;
  Result<Buffer> ReadRecord(std::uint64_t offset, std::uint64_t length, Opcode opcode,
                            std::uint64_t most);

  const std::unique_ptr<os::RandomAccessFile> file_;
  const ReaderLimits limits_;
  BufferedFile buffered_;  // to go from record to record
  BufferedFile exact_;     // to go to a single one
  Contents contents_;
  Problems problems_;
  bool was_scanned_ = false;
  std::vector<std::pair<const MessageBlock*, std::shared_ptr<const RawBuffer>>>
      cache_;                            // latest last
  std::uint64_t cache_size_ = 0;         // bytes
  std::set<std::uint64_t> lost_blocks_;  // their offsets, of which a Problem tells already
};

/// Messages one after the other, in the order of the Query. Chunks whose times overlap are read
/// side by side; one that was decompressed stays in the reader's cache as long as that has room.
///
/// Cost: reading and decompressing each chunk that can contain such a message; then about 100 ns a
/// message.
class MessageStream {
 public:
  MessageStream(MessageStream&&) = default;

  /// Empty at the end. The data is valid until the next call of any function of the reader or its
  /// streams.
  std::optional<Message> Next();
  /// False if a block that may contain such messages could not be read, so some may be missing: the
  /// reader's problems() say which.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  friend class Reader;

  /// The messages of one block that match and are still to come.
  struct Source {
    const MessageBlock* block = nullptr;
    std::vector<MessageIndexEntry> entries;
    std::size_t next = 0;
  };
  struct Head {
    Timestamp time = 0;
    std::uint64_t block_offset = 0;
    std::size_t source = 0;

    bool operator>(const Head& other) const {
      return time != other.time ? time > other.time : block_offset > other.block_offset;
    }
  };

  MessageStream(Reader& reader, Query query);

  std::optional<Message> FindNext();
  void OpenBlocks();
  void Open(const MessageBlock& block);
  void Collect(const MessageBlock& block, Bytes records, std::vector<MessageIndexEntry>& entries);
  [[nodiscard]] bool Wants(const MessageBlock& block) const;
  [[nodiscard]] bool Wants(ChannelId channel) const;
  std::optional<Message> Fetch(const Source& source);

  Reader* reader_;
  Query query_;
  std::vector<bool> wanted_;                 // by channel; empty: all
  std::vector<const MessageBlock*> blocks_;  // in the order in which they are opened
  std::size_t next_block_ = 0;
  std::vector<Source> sources_;
  std::vector<std::size_t> free_sources_;
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads_;
  std::uint64_t entries_size_ = 0;  // bytes
  bool is_complete_ = true;
  bool is_started_ = false;
};

}  // namespace tendon::mcap
