#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/payload/schema.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_format.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tendon::recording {

/// A column or an event in a recording, during one run of its source.
struct PlayedChannel {
  std::string path;  ///< "robot/arm/state.Joints"
  Schema schema;
  std::uint64_t run = 0;  ///< the epoch of the source; its ticks begin again with each run
  bool is_event = false;
};

/// The value of a column in one row. The body is valid during the call.
struct PlayedValue {
  const PlayedChannel* channel = nullptr;
  std::uint64_t tick = 0;  ///< the low 32 bits, as in the file
  mcap::Bytes body;        ///< CDR
};

struct PlayedEvent {
  const PlayedChannel* channel = nullptr;
  mcap::Bytes value;  ///< CDR, valid during the call
};

/// A change of the catalogue. A snapshot begins with an empty catalogue.
struct PlayedChange {
  CatalogueChange change;
  bool begins_snapshot = false;
};

/// Something that happened at one time.
struct PlayedItem {
  mcap::Timestamp time = 0;  ///< log time
  std::variant<PlayedValue, PlayedEvent, RosLog, Loss, PlayedChange> content;
};

/// A time span of the recording in which something happened; one moment if both are the same.
struct PlayedSpan {
  mcap::Timestamp from = 0;
  mcap::Timestamp to = 0;

  bool operator==(const PlayedSpan&) const = default;
};

/// A recording as of one moment, its position, which can be moved forth and back.
///
///     auto playback = Playback::Open(std::move(reader));
///     (*playback)->Choose({"robot/arm/state.Joints"});
///     (*playback)->Seek(time);                     // the past: Past(), CatalogueNow()
///     (*playback)->PlayUpTo(time + 33ms, handler);  // what happens from there on
///
/// Reads by the index of the file: the cost of each function grows with the part of the file that
/// it hands out, not with the file. A file without an index was read once by its reader.
///
/// Events, the log, losses and changes of the catalogue are always handed out; values of columns
/// only if they were chosen, because they are nearly the whole file. Calls of commands are left
/// out, because a component may be called in every cycle.
///
/// Thread safety: one thread at a time.
class Playback {
 public:
  using Handler = std::function<void(const PlayedItem&)>;
  enum class Kind { kEvents, kLosses };
  enum class WithLosses { kNo, kYes };

  /// kInvalid if the file contains nothing that Tendon recorded, no message, or one at a time that
  /// does not fit in 64 bits with a sign.
  static Result<std::unique_ptr<Playback>> Open(std::unique_ptr<mcap::Reader> reader);
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  [[nodiscard]] const mcap::Reader& reader() const { return *reader_; }
  /// The times of the first and the last message.
  [[nodiscard]] mcap::Timestamp first_time() const { return first_time_; }
  [[nodiscard]] mcap::Timestamp last_time() const { return last_time_; }
  /// The paths of all columns, sorted.
  [[nodiscard]] std::vector<std::string> columns() const;
  /// The type of a column in its latest run; null if there is no such column.
  [[nodiscard]] const Schema* FindSchema(const std::string& column) const;

  /// The types of all columns and events.
  [[nodiscard]] std::vector<Schema> types() const;

  /// Sets the columns whose values are handed out; unknown ones have no effect.
  void Choose(const std::vector<std::string>& columns);

  /// All up to this time has happened. At the begin, the position is before the first message.
  [[nodiscard]] mcap::Timestamp position() const { return position_; }
  /// Moves the position without handing out anything.
  void Seek(mcap::Timestamp time);
  /// Hands out what happened after the position, up to and including `time`, in the order of time,
  /// and moves the position to `time`. Does nothing if `time` is not after the position.
  void PlayUpTo(mcap::Timestamp time, const Handler& handler);

  /// The catalogue as of the position; before the first one in the file, the first one. A file
  /// without any has one that is made of the paths of its columns.
  [[nodiscard]] Catalogue CatalogueNow();

  /// Hands out the values of `columns` from `from` to the position, with the losses in this span if
  /// they are wanted. A column without a value in it has its newest value before it, if there is
  /// one in the last 64 chunks that have values of such columns.
  void Past(const std::vector<std::string>& columns, mcap::Timestamp from, WithLosses losses,
            const Handler& handler);
  /// Hands out the last `most` events or log records up to the position, oldest first;
  /// fewer if the last 64 chunks that have some have fewer.
  void LastEvents(std::size_t most, const Handler& handler);
  void LastLog(std::size_t most, const Handler& handler);

  /// The time of the next row of the chosen columns or event after the position, and of the last
  /// one before it.
  [[nodiscard]] std::optional<mcap::Timestamp> NextStep();
  [[nodiscard]] std::optional<mcap::Timestamp> PreviousStep();
  /// The next event or loss after `time`, and the last one before it.
  [[nodiscard]] std::optional<mcap::Timestamp> FindNext(Kind kind, mcap::Timestamp time);
  [[nodiscard]] std::optional<mcap::Timestamp> FindPrevious(Kind kind, mcap::Timestamp time);
  /// When there were events or losses: each one of them or, in a large file, the chunks that
  /// contain some.
  [[nodiscard]] std::vector<PlayedSpan> Spans(Kind kind);

 private:
  using Channels = std::vector<mcap::ChannelId>;  // sorted, except to play

  explicit Playback(std::unique_ptr<mcap::Reader> reader);

  Result<void> FindChannels();
  Result<void> FindTimes();
  void MakeCatalogue();
  [[nodiscard]] const Channels& ChannelsOf(Kind kind) const;
  [[nodiscard]] Channels ChannelsOf(const std::vector<std::string>& columns) const;
  [[nodiscard]] Channels StepChannels() const;
  [[nodiscard]] Channels PlayedChannels() const;
  void HandOut(const mcap::Message& message, const Handler& handler) const;
  void ReadChangesUpTo(mcap::Timestamp time);
  /// The blocks that may contain messages of these channels up to `time`, by their end, latest
  /// first.
  [[nodiscard]] std::vector<const mcap::MessageBlock*> BlocksBefore(const Channels& channels,
                                                                    mcap::Timestamp time) const;
  void Last(const Channels& channels, std::size_t most, const Handler& handler);
  std::optional<mcap::Timestamp> Next(const Channels& channels, mcap::Timestamp time);
  std::optional<mcap::Timestamp> Previous(const Channels& channels, mcap::Timestamp time);

  /// A message that owns its data.
  struct OwnMessage {
    mcap::Message message;
    std::vector<std::byte> data;
  };

  const std::unique_ptr<mcap::Reader> reader_;
  std::map<mcap::ChannelId, PlayedChannel> channels_;
  std::map<std::string, Channels> columns_;  // by path; in the order of their ids
  Channels events_;
  Channels losses_;
  Channels log_;
  Channels catalogues_;
  mcap::Timestamp first_time_ = 0;
  mcap::Timestamp last_time_ = 0;

  Channels chosen_;
  mcap::Timestamp position_ = 0;
  std::optional<mcap::MessageStream> stream_;  // what follows the position
  std::optional<OwnMessage> next_;             // was taken out of the stream, is after the position

  std::optional<mcap::MessageStream> change_stream_;
  std::vector<std::pair<mcap::Timestamp, PlayedChange>> changes_;  // read so far
  bool has_all_changes_ = false;
  Catalogue made_catalogue_;  // if the file has none
};

}  // namespace tendon::recording
