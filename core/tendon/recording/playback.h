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
  std::uint64_t run = 0;  ///< the epoch of the source; the ticks restart with each run
  bool is_event = false;
};

/// The value of a column in one row. The body is valid during the call.
struct PlayedValue {
  const PlayedChannel* channel = nullptr;
  std::uint64_t tick = 0;  ///< the low 32 bits, as in the file
  mcap::ByteView body;     ///< CDR
};

struct PlayedEvent {
  const PlayedChannel* channel = nullptr;
  mcap::ByteView value;  ///< CDR, valid during the call
};

/// A change of the catalogue. A snapshot begins with an empty catalogue.
struct PlayedChange {
  CatalogueChange change;
  bool begins_snapshot = false;
};

/// An item of the recording, with its time.
struct PlayedItem {
  mcap::Timestamp time = 0;  ///< log time
  std::variant<PlayedValue, PlayedEvent, RosLog, Loss, PlayedChange> content;
};

/// A time span of the recording that contains events or losses. If both times are equal, it is one
/// moment.
struct PlayedSpan {
  mcap::Timestamp from = 0;
  mcap::Timestamp to = 0;

  bool operator==(const PlayedSpan&) const = default;
};

/// A view of a recording at one moment, the position. The position can be moved forwards and
/// backwards.
///
///     auto playback = Playback::Open(std::move(reader));
///     (*playback)->Choose({"robot/arm/state.Joints"});
///     (*playback)->Seek(time);                     // the past: Past(), CatalogueNow()
///     (*playback)->PlayUpTo(time + 33ms, handler); // the following items
///
/// Uses the index of the file: the cost of each function depends on how much it returns, not on the
/// size of the file. If a file has no index, its reader has read the whole file once.
///
/// Handlers always get events, log records, losses and changes of the catalogue. They get values
/// only of chosen columns, because values make up most of the file. Calls of commands are left out,
/// because a component may be called in every cycle.
///
/// Thread safety: one thread at a time.
class Playback {
 public:
  using Handler = std::function<void(const PlayedItem&)>;
  enum class Kind { kEvents, kLosses };
  enum class WithLosses { kNo, kYes };

  /// Fails with kInvalid if the file has no messages, was not recorded by Tendon, or has a message
  /// whose time does not fit in a signed 64-bit number.
  static Result<std::unique_ptr<Playback>> Open(std::unique_ptr<mcap::Reader> reader);
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  [[nodiscard]] const mcap::Reader& reader() const { return *reader_; }
  /// The times of the first and the last message.
  [[nodiscard]] mcap::Timestamp first_time() const { return first_time_; }
  [[nodiscard]] mcap::Timestamp last_time() const { return last_time_; }
  /// The paths of all columns, sorted.
  [[nodiscard]] std::vector<std::string> columns() const;
  /// Returns the type of a column in its latest run; null if there is no such column.
  [[nodiscard]] const Schema* FindSchema(const std::string& column) const;

  /// The types of all columns and events.
  [[nodiscard]] std::vector<Schema> types() const;

  /// Chooses the columns whose values PlayUpTo() passes to its handler. Ignores unknown columns.
  void Choose(const std::vector<std::string>& columns);

  /// The position: all items up to this time have happened. At first, the position is before the
  /// first message.
  [[nodiscard]] mcap::Timestamp position() const { return position_; }
  /// Moves the position without calling a handler.
  void Seek(mcap::Timestamp time);
  /// Calls the handler for all items after the position, up to and including `time`, in the order
  /// of their times. Moves the position to `time`. Does nothing if `time` is not after the
  /// position.
  void PlayUpTo(mcap::Timestamp time, const Handler& handler);

  /// Returns the catalogue at the position. If the position is before the first catalogue of the
  /// file, returns the first one. If the file has no catalogue, returns one that is made from the
  /// paths of the columns.
  [[nodiscard]] Catalogue CatalogueNow();

  /// Calls the handler for the values of `columns` from `from` to the position, and for the losses
  /// in this span if they are wanted. If a column has no value in this span, its newest earlier
  /// value is used, provided that it is in the last 64 chunks with values of these columns.
  void Past(const std::vector<std::string>& columns, mcap::Timestamp from, WithLosses losses,
            const Handler& handler);
  /// Calls the handler for the last `most` events or log records up to the position, oldest first.
  /// Searches only the last 64 chunks with such items, so it may find fewer.
  void LastEvents(std::size_t most, const Handler& handler);
  void LastLog(std::size_t most, const Handler& handler);

  /// Return the time of the next, or of the previous, row of a chosen column or event, relative to
  /// the position.
  [[nodiscard]] std::optional<mcap::Timestamp> NextStep();
  [[nodiscard]] std::optional<mcap::Timestamp> PreviousStep();
  /// Return the time of the next event or loss after `time`, or of the last event or loss before
  /// it.
  [[nodiscard]] std::optional<mcap::Timestamp> FindNext(Kind kind, mcap::Timestamp time);
  [[nodiscard]] std::optional<mcap::Timestamp> FindPrevious(Kind kind, mcap::Timestamp time);
  /// Returns the time spans that contain events or losses: one for each event or loss or, in a
  /// large file, one for each chunk that contains some.
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
  /// Returns the blocks that may contain messages of these channels up to `time`, sorted by their
  /// end, latest first.
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
  std::optional<mcap::MessageStream> stream_;  // the messages after the position
  std::optional<OwnMessage> next_;             // taken from the stream; it is after the position

  std::optional<mcap::MessageStream> change_stream_;
  std::vector<std::pair<mcap::Timestamp, PlayedChange>> changes_;  // read so far
  bool has_all_changes_ = false;
  Catalogue made_catalogue_;  // used if the file has no catalogue
};

}  // namespace tendon::recording
