#pragma once

#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/mcap/chunk.h>
#include <tendon/recording/mcap/contents.h>
#include <tendon/recording/mcap/records.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tendon::mcap {

class MessageStream;

/// The messages to read, and their order.
struct Query {
  enum class Order {
    kLogTime,  ///< by log time; messages of the same time by their place in the file
    kFile,     ///< by the place in the file
  };

  Timestamp from = kFirstTime;
  Timestamp to = kLastTime;         ///< inclusive
  std::vector<ChannelId> channels;  ///< empty: all channels
  Order order = Order::kLogTime;
};

/// Reads an MCAP file, even if it is damaged, cut off, or still being written.
///
///     const auto reader = Reader::Open("run.mcap");
///     auto messages = (*reader)->Messages({.from = start, .to = end});
///     while (const auto message = messages.Next()) Use(*message);
///     for (const Problem& problem : (*reader)->problems().first()) Warn(problem.sentence);
///
/// Open() reads only the header, the footer and the summary. If the summary is missing, damaged or
/// incomplete, it reads the whole file once. The reader skips data that contradicts its checksum,
/// its length or its index, and adds a Problem. It does not use the message indexes of the file,
/// because they have no checksum. It finds messages with the chunk indexes in the summary and the
/// records in the chunks, because both have checksums.
///
/// Memory: the summary, and the limits in ReaderLimits. No function throws.
///
/// Thread safety: one thread at a time may use a reader and its streams. Several readers of one
/// file are independent.
class Reader {
 public:
  /// Fails with kNotFound or kFailed if the file cannot be opened. Fails with kInvalid if the file
  /// is not an MCAP file of version 0; the error shows the beginning of the file.
  static Result<std::unique_ptr<Reader>> Open(const std::filesystem::path& file,
                                              const ReaderLimits& limits = {});
  static Result<std::unique_ptr<Reader>> Open(std::unique_ptr<os::RandomAccessFile> file,
                                              const ReaderLimits& limits = {});
  /// Ignores the summary and reads the whole file. Recover() uses this.
  static Result<std::unique_ptr<Reader>> OpenByScan(std::unique_ptr<os::RandomAccessFile> file,
                                                    const ReaderLimits& limits = {});
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader();

  [[nodiscard]] const std::string& name() const { return file_->name(); }
  [[nodiscard]] const Header& header() const { return contents_.header; }
  [[nodiscard]] const std::map<SchemaId, Schema>& schemas() const { return contents_.schemas; }
  [[nodiscard]] const std::map<ChannelId, Channel>& channels() const { return contents_.channels; }
  /// Returns null if there is no such channel.
  [[nodiscard]] const Channel* FindChannel(ChannelId id) const;
  /// The statistics in the summary, if there are any. After a scan, the statistics of the records
  /// that were found.
  [[nodiscard]] const std::optional<Statistics>& statistics() const { return contents_.statistics; }
  /// The blocks, sorted by their place in the file.
  [[nodiscard]] const std::vector<MessageBlock>& blocks() const { return contents_.blocks; }
  [[nodiscard]] const std::vector<AttachmentIndex>& attachments() const {
    return contents_.attachments;
  }
  [[nodiscard]] const std::vector<MetadataIndex>& metadata() const { return contents_.metadata; }
  /// True if another program still writes the file.
  [[nodiscard]] bool is_being_written() const { return file_->is_being_written(); }
  /// True if the whole file was read instead of the summary.
  [[nodiscard]] bool was_scanned() const { return was_scanned_; }
  /// The damaged and missing parts that were found up to now. Reading messages can add more.
  [[nodiscard]] const Problems& problems() const { return problems_; }
  /// The number of records that were skipped, because this version does not know their kind.
  [[nodiscard]] std::uint64_t unknown_records() const { return contents_.unknown_records; }

  /// Returns the messages that match. The reader must outlive the stream. Nothing is read before
  /// Next().
  [[nodiscard]] MessageStream Messages(Query query = {});

  /// Fails with kInvalid if the attachment is damaged or larger than the limit, and with kFailed if
  /// the disk reports an error.
  Result<Attachment> ReadAttachment(const AttachmentIndex& index);
  /// Fails like ReadAttachment(). Metadata have no checksum, so only Verify() finds a wrong byte.
  Result<Metadata> ReadMetadata(const MetadataIndex& index);
  /// Returns the message indexes after a chunk without any changes. Fails with kInvalid if they are
  /// damaged.
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
      cache_;                            // sorted by last use
  std::uint64_t cache_size_ = 0;         // bytes
  std::set<std::uint64_t> lost_blocks_;  // offsets of the blocks that have a Problem already
};

/// Returns messages one after the other, in the order of the Query. Chunks whose times overlap are
/// read in parallel. A decompressed chunk stays in the reader's cache as long as the cache has
/// room.
///
/// Cost: each chunk that can contain a matching message is read and decompressed. Then, a message
/// costs about 100 ns.
class MessageStream {
 public:
  MessageStream(MessageStream&&) = default;

  /// Returns nothing at the end. The data is valid until the next call of any function of the
  /// reader or its streams.
  std::optional<Message> Next();
  /// False if messages may be missing, because a block that may contain some could not be read. The
  /// reader's problems() name this block.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  friend class Reader;

  /// The messages of one block that match and were not returned yet.
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
  void Collect(const MessageBlock& block, ByteView records,
               std::vector<MessageIndexEntry>& entries);
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
