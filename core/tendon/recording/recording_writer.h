#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/os/random_access_file.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/recording/mcap/writer.h>
#include <tendon/recording/recording_entry.h>
#include <tendon/recording/recording_format.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon::recording {

/// Where and how a recording is written.
struct FileOptions {
  std::filesystem::path file;  ///< "run.mcap"; with a split "run-1.mcap", "run-2.mcap" ...
  mcap::Compression compression = mcap::Compression::kZstd;
  std::uint64_t split_size = 0;            ///< approximate size of a file, in bytes; 0: no limit
  std::chrono::nanoseconds split_time{0};  ///< 0: no limit
  std::size_t keep = 0;                    ///< number of newest files to keep; 0: all
  /// Creates a file; if empty, the function of the operating system is used. Tests simulate a slow
  /// or failing disk with it.
  std::function<Result<std::unique_ptr<os::WritableFile>>(const std::filesystem::path&)> create{};
  /// Log records that are at most this much older than the start belong to the recording.
  std::chrono::nanoseconds past{0};
};

/// Returns the name of the file with this number, which begins at 1: "run-2.mcap". Without a split,
/// returns "run.mcap".
[[nodiscard]] std::filesystem::path FileName(const FileOptions& options, std::size_t number);

/// The description of a recording. Each of its files contains it.
struct Heading {
  std::map<std::string, std::string> about;
  std::string system;  ///< the text of the system file; empty for none
};

/// The content of a recording up to now, in all its files.
struct Counts {
  std::uint64_t rows = 0;
  std::uint64_t events = 0;
  std::uint64_t commands = 0;  ///< calls
  std::uint64_t log = 0;       ///< records
  std::uint64_t bytes = 0;     ///< size of the files that are kept
  std::size_t files = 0;       ///< number of files that were begun
};

/// Writes entries into one MCAP file, or into several files, one after the other. Each file can be
/// read without the others, because it begins with the whole catalogue.
///
/// A column is a channel with the topic `robot/arm/state/Joints`. A row is one message on each
/// channel of its table, with the low 32 bits of the tick as the sequence. The log time is the time
/// of the row on this machine's clock; later corrections of the wall time have no effect on it. A
/// restarted source gets new channels, because its ticks restart.
///
/// Thread safety: one thread at a time; the recorder's writing thread uses it. Cost: as for
/// mcap::Writer, for each cell of a row.
class RecordingWriter {
 public:
  /// Begins a recording now. Fails with kExists if there is a file with this name.
  static Result<std::unique_ptr<RecordingWriter>> Create(FileOptions options, Heading heading);
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  /// Fails with kInvalid if the file cannot hold this entry, for example because a type is too
  /// large or the channels are used up; other entries can still be written. With a split, a new
  /// file begins before the channels are used up. After any other error, only Close() has an
  /// effect; the error says how much is safe. losses() counts the entries that were not written.
  Result<void> Write(const RecordingEntry& entry);
  /// Writes a loss that no rows follow. Its time is the present time.
  Result<void> WriteLoss(const std::string& path, const LostRows& lost);
  /// Writes a loss at an earlier `time`.
  Result<void> WriteLoss(const std::string& path, const LostRows& lost, SteadyTime time);
  /// Waits until all data is on the disk.
  Result<void> Sync();
  /// Writes the losses of the whole recording, which are the sum of losses() and `others`, and
  /// completes the file. Returns the failure of an earlier Write() if there was one.
  Result<void> Close(const Losses& others);

  /// The entries that were passed to Write() and are in no file: refused entries and, after a
  /// failure, the entries of the chunk that could not be written. Rows count as lost by the
  /// recorder.
  [[nodiscard]] Losses losses() const;
  /// The content of the files, including the present chunk.
  [[nodiscard]] Counts counts() const;
  /// The file that is being written.
  [[nodiscard]] const std::filesystem::path& file() const { return files_.back().first; }

 private:
  /// A run of a source, from its start on.
  struct Run {
    const char* kind = "";  // see kKindKey
    std::uint64_t epoch = 0;
    std::int64_t clock = 0;  // see kClockKey
    std::chrono::nanoseconds uncertainty{0};
  };
  /// The channels of a source.
  struct Channels {
    std::shared_ptr<const EntrySource> source;
    std::uint64_t epoch = 0;
    std::vector<mcap::ChannelId> ids;      // by member
    std::vector<std::uint32_t> sequences;  // of the next event or call, by member
    std::int64_t clock = 0;                // see kClockKey
    std::optional<Error> refusal;          // the reason why the file cannot hold this source
  };
  /// A channel of the recorder itself.
  struct OwnChannel {
    std::optional<mcap::ChannelId> id;
    std::uint32_t sequence = 0;
  };

  /// An accepted entry whose chunk may not be written yet: rows of a table, an event, a call or a
  /// log record.
  struct AcceptedEntry {
    std::shared_ptr<const EntrySource> source;  // null for a log record
    std::optional<std::size_t> event;           // index of the member; empty for rows
    std::uint64_t first = 0;                    // the number of the first message in the file
    std::uint64_t width = 1;                    // number of messages of one row
    std::uint64_t count = 0;                    // rows
  };

  RecordingWriter(FileOptions options, Heading heading);

  Result<void> TryWrite(const RecordingEntry& entry);
  void ForgetWritten();
  [[nodiscard]] std::uint64_t UnwrittenOf(const AcceptedEntry& one) const;
  [[nodiscard]] Losses UnwrittenChunk() const;
  Result<void> Put(const RowsEntry& rows);
  Result<void> Put(const EventEntry& event);
  Result<void> Put(const LogEntry& entry);
  Result<void> Put(const CatalogueEntry& changes);
  Result<void> Put(const Loss& loss, mcap::Timestamp time);
  Result<void> PutCatalogue(const std::vector<CatalogueChange>& changes, mcap::Timestamp time);

  Result<void> BeginFile();
  Result<std::unique_ptr<mcap::Writer>> CreateWriter(const std::filesystem::path& name) const;
  Result<void> BeginNextFileIfDue();
  [[nodiscard]] bool HasManyOldChannels() const;
  [[nodiscard]] std::filesystem::path NextName();
  void DropOldFiles();
  Result<mcap::SchemaId> SchemaIdOf(const std::string& name, const std::string& text);
  Result<Channels*> ChannelsOf(std::map<InterfaceName, Channels>& known,
                               const std::shared_ptr<const EntrySource>& source, const Run& run);
  Result<void> AddChannels(Channels& channels, const Run& run);
  template <typename T>
  Result<void> PutOwn(OwnChannel& channel, const char* topic, const T& value, mcap::Timestamp time);
  Result<void> PutBody(mcap::ChannelId channel, std::uint32_t sequence, mcap::Timestamp log_time,
                       mcap::Timestamp publish_time, mcap::ByteView body);
  [[nodiscard]] mcap::Timestamp WallOf(SteadyTime time) const;

  const FileOptions options_;
  const Heading heading_;
  const std::int64_t wall_minus_steady_;  // ns
  const std::int64_t begin_;              // wall time, ns
  std::unique_ptr<mcap::Writer> writer_;
  SteadyTime file_begin_;
  std::size_t number_ = 0;                                             // of the file
  std::deque<std::pair<std::filesystem::path, std::uint64_t>> files_;  // kept files, sizes

  // Of the present file.
  std::map<std::pair<std::string, std::string>, mcap::SchemaId> schemas_;  // by name and text
  std::size_t channel_count_ = 0;                                          // of sources
  std::map<InterfaceName, Channels> tables_;
  std::map<InterfaceName, Channels> events_;
  std::map<InterfaceName, Channels> commands_;
  OwnChannel log_;
  OwnChannel losses_;
  OwnChannel changes_;

  std::vector<std::byte> body_;
  std::vector<std::byte> message_;
  Catalogue catalogue_;
  Counts counts_;                       // counts of accepted entries
  std::deque<AcceptedEntry> accepted_;  // oldest first
  Losses refused_;
  std::optional<Error> failure_;
};

}  // namespace tendon::recording
