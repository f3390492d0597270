#pragma once

#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/mcap/compression.h>
#include <tendon/recording/mcap/records.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon::mcap {

/// Options for writing a file.
struct WriterOptions {
  std::string profile;  ///< for example "ros2"; see mcap.dev/spec/registry
  std::string library = "tendon";
  Compression compression = Compression::kZstd;
  int level = 0;  ///< level of the compression; 0: the default
  /// A chunk is written when its messages have this many bytes before compression. After a crash,
  /// at most one chunk is lost. A reader reads whole chunks. Limited to 4 KiB to 64 MiB.
  std::size_t chunk_size = std::size_t{1} << 20U;
  /// Memory for the index of the file, in bytes: about 80 bytes for each chunk and 16 bytes for
  /// each channel in a chunk. Write() fails when this memory is used up.
  std::size_t largest_index = std::size_t{256} << 20U;
};

/// Counts of the messages that were accepted, written or synced.
struct Progress {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;      ///< of the file
  Timestamp last_log_time = 0;  ///< log time of the latest message

  bool operator==(const Progress&) const = default;
};

/// Returns kExists, and whether another program is recording into the file: "run.mcap is being
/// recorded by another program: ...". On a disk without locks this cannot be seen.
Error FileExistsError(const std::filesystem::path& file);

/// Writes an MCAP file, chunk by chunk, and its index and summary at the end.
///
/// A chunk begins with the schemas and channels that were new in the previous chunk; some chunks
/// begin with all of them. Therefore, if a chunk is damaged, a reader without the summary can still
/// read all other chunks.
///
/// The file is append-only: a complete chunk never changes. Therefore, all written chunks can be
/// read after SIGKILL or on a full disk, and all synced chunks after a power cut. Space for the
/// summary is reserved in advance, so that Close() can complete the file even if the disk is full.
///
///     auto writer = Writer::Create("run.mcap", {.profile = "ros2"});
///     const auto schema = (*writer)->AddSchema("arm/msg/JointState", "ros2msg", text);
///     const auto channel = (*writer)->AddChannel(*schema, "robot/arm/state/Joints", "cdr");
///     (*writer)->Write({.channel_id = *channel, .log_time = now, .publish_time = now, .data =
///     row});
///     (*writer)->Sync();   // once a second
///     (*writer)->Close();
///
/// Errors: after a failed write, all later calls except Close() fail with the same error, which
/// says how much is safe. A refused argument (kInvalid) changes nothing. No function throws.
///
/// Memory: twice the chunk size, three times the largest message, a few MiB for the compression,
/// and the index. Cost: Write() copies the message, which takes 50 ns and 0.1 ns for each byte. The
/// call that fills a chunk also compresses and writes it.
///
/// Thread safety: one thread at a time. Not for real-time threads.
class Writer {
 public:
  /// The maximum size of a message in bytes. It ensures that each reader can load the chunk of the
  /// message.
  static constexpr std::size_t kLargestMessage = std::size_t{128} << 20U;
  /// The maximum size of a schema, of the texts of a channel, or of metadata, in bytes.
  static constexpr std::size_t kLargestText = std::size_t{16} << 20U;
  /// The maximum size of the metadata that Close() can write to a full disk, in bytes.
  static constexpr std::size_t kLastMetadata = std::size_t{4} << 10U;

  /// Creates the file and writes its beginning. Fails with FileExistsError() if there is a file
  /// with this name.
  static Result<std::unique_ptr<Writer>> Create(const std::filesystem::path& file,
                                                const WriterOptions& options = {});
  /// Writes into an empty file that the caller has opened.
  static Result<std::unique_ptr<Writer>> Create(std::unique_ptr<os::WritableFile> file,
                                                const WriterOptions& options = {});
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  /// Calls Close() and ignores its result.
  ~Writer();

  /// Return the id of the schema or channel in this file, which can be used at once. They fail with
  /// kInvalid if the schema is unknown, the text is too large, or the file already has 65,535
  /// schemas or channels.
  Result<SchemaId> AddSchema(const std::string& name, const std::string& encoding,
                             const std::string& data);
  Result<ChannelId> AddChannel(SchemaId schema, const std::string& topic,
                               const std::string& message_encoding,
                               const std::map<std::string, std::string>& metadata = {});

  /// Adds a message to the present chunk. Times may be in any order. Fails with kInvalid if the
  /// channel is unknown or the message is larger than kLargestMessage.
  Result<void> Write(const Message& message);
  /// Writes an attachment to the file at once, after the complete chunks.
  Result<void> Write(const Attachment& attachment);
  Result<void> Write(const Metadata& metadata);

  /// Writes the present chunk, unless it is empty, and waits until all data is on the disk.
  Result<void> Sync();
  /// Writes the present chunk without waiting for the disk.
  Result<void> Flush();
  /// Writes the present chunk, `last`, the index and the summary, and waits until all data is on
  /// the disk. After a failed write, completes the file with the earlier chunks and up to
  /// kLastMetadata bytes of `last`. If this fails, too, the file has no summary; Recover() can make
  /// one. A second call returns the same result.
  Result<void> Close(std::span<const Metadata> last = {});

  /// The error of the first failed write; empty if there was none.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

  /// Counts of all messages that Write() has accepted.
  [[nodiscard]] const Progress& accepted() const { return accepted_; }
  /// Counts of the messages in complete chunks of the file. They are safe if the process is killed.
  [[nodiscard]] const Progress& written() const { return written_; }
  /// Counts of the messages that were on the disk after the last Sync(). They are safe if the power
  /// fails.
  [[nodiscard]] const Progress& synced() const { return synced_; }
  /// The memory of the index, in bytes. When it reaches half of WriterOptions::largest_index, a new
  /// file should begin.
  [[nodiscard]] std::size_t index_size() const { return index_size_; }

 private:
  struct ChannelState {
    Channel channel;
    std::uint64_t messages = 0;     // in the file
    std::size_t in_chunk = 0;       // in the present chunk
    std::size_t index_place = 0;    // place of its next entry in index_, while index_ is made
    std::uint64_t index_begin = 0;  // start of its record in index_
  };
  struct ChunkEntry {
    ChannelId channel;
    MessageIndexEntry entry;
  };

  Writer(std::unique_ptr<os::WritableFile> file, const WriterOptions& options);

  template <typename Call>
  auto Guarded(const Call& call) -> decltype(call());
  Result<void> Begin();
  Result<void> CheckOpen() const;
  Result<void> AddMessage(const Message& message);
  Result<void> MakeRoom(std::size_t size);
  void BeginChunk();
  Result<void> WriteChunk();
  void WriteLast(std::span<const Metadata> last);
  Result<void> WriteRecords(std::span<const ByteView> parts, std::uint32_t crc);
  void MakeMessageIndexes(ChunkIndex& index);
  void CountChunk(ChunkIndex index);
  Result<void> WriteSummary();
  [[nodiscard]] Buffer Summary(std::uint64_t start) const;
  [[nodiscard]] Statistics MakeStatistics() const;
  [[nodiscard]] std::uint64_t SummarySize() const;
  [[nodiscard]] Error Failure(const Error& reason) const;
  [[nodiscard]] Error SyncFailure(const Error& reason) const;

  const std::unique_ptr<os::WritableFile> file_;
  const WriterOptions options_;
  Compressor compressor_;
  std::uint64_t end_ = 0;  // of the complete records in the file
  std::uint32_t crc_ = 0;  // of all of them
  std::optional<Error> failure_;
  std::optional<Result<void>> closed_;

  std::vector<Schema> schemas_;         // by id - 1
  std::vector<ChannelState> channels_;  // likewise
  std::size_t text_size_ = 0;           // of both in the summary, bytes
  std::size_t repeated_schemas_ = 0;    // that later chunks need not repeat
  std::size_t repeated_channels_ = 0;   // likewise
  std::uint64_t next_repeat_ = 0;       // size of the file at which all definitions are repeated

  Buffer chunk_;                     // the records of the present chunk
  std::vector<ChunkEntry> entries_;  // its messages
  std::vector<ChannelId> used_;      // the channels of its messages
  Timestamp chunk_start_ = 0;
  Timestamp chunk_end_ = 0;
  Buffer head_;
  Buffer index_;  // its message indexes

  std::vector<ChunkIndex> chunks_;
  std::vector<AttachmentIndex> attachments_;
  std::vector<MetadataIndex> metadata_;
  std::size_t index_size_ = 0;
  Timestamp first_time_ = 0;
  Timestamp last_time_ = 0;

  Progress accepted_;
  Progress written_;
  Progress synced_;
};

}  // namespace tendon::mcap
