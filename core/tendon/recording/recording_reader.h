#pragma once

#include <tendon/base/name.h>
#include <tendon/manager/component_description.h>
#include <tendon/payload/schema.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_format.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tendon::recording {

/// A column of a recorded table, a recorded event, or a command with the type of its calls.
struct RecordedMember {
  std::string name;
  Schema schema;
  std::size_t largest = 0;  ///< size of the largest value, bytes
};

/// The members of a state table, or the events or the commands of an interface, that a recording
/// contains.
struct RecordedSource {
  InterfaceName name;
  std::vector<RecordedMember> members;
  bool is_table = false;
  bool are_commands = false;
  std::uint64_t first_tick = 0;    ///< of a table
  std::uint64_t count = 0;         ///< rows, events or calls
  mcap::Timestamp first_time = 0;  ///< log time; 0 if there is none
  mcap::Timestamp last_time = 0;
};

/// A row of a table. Ticks only grow: where the ticks in the file begin again, because the source
/// was restarted, they go on here with the next tick.
struct RecordedRow {
  std::uint64_t tick = 0;
  std::vector<std::vector<std::byte>> cells;  ///< CDR bodies, by column; empty if there is no value
};
/// An event, or a call of a command.
struct RecordedEvent {
  std::size_t event = 0;         ///< index of the member
  std::vector<std::byte> value;  ///< a CDR body
};

/// A row, an event or a log record, with its time.
struct RecordedItem {
  mcap::Timestamp time = 0;  ///< the log time; of a call, the time when its execution had ended
  std::size_t source = 0;    ///< index of RecordingReader::sources(); not for the log
  std::variant<RecordedRow, RecordedEvent, RosLog> content;
};

/// What RecordingReader::Open() counts.
struct RecordedCounts {
  std::uint64_t rows = 0;
  std::uint64_t events = 0;
  std::uint64_t commands = 0;  ///< calls
  std::uint64_t log = 0;       ///< records
  /// Messages that are left out: their channels are not Tendon's, or their type differs from the
  /// one that the same path had before.
  std::uint64_t left_out = 0;
  mcap::Timestamp first_time = 0;
  mcap::Timestamp last_time = 0;
};

/// Reads a recording as rows, events, calls and log records, in the order of their times: the
/// counterpart of RecordingWriter, for the replay. The order of each table, and of the events of
/// each interface, is that of the file.
///
///     auto recording = RecordingReader::Open(*reader, query);
///     while (auto item = (*recording)->Next()) Play(*item);
///
/// Cost: Open() reads the part once, to know the sizes of all values. Memory: one item for each
/// source, and what the MCAP reader keeps.
///
/// Thread safety: one thread at a time, which is also that of the MCAP reader. That reader must
/// outlive it.
class RecordingReader {
 public:
  static constexpr std::size_t kMostSources = 4096;

  /// Takes the messages that match; the order in `query` is not used. kInvalid if the part contains
  /// no row, event or call that can be read, or more than kMostSources tables and interfaces.
  static Result<std::unique_ptr<RecordingReader>> Open(mcap::Reader& reader, mcap::Query query);
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;
  ~RecordingReader();

  [[nodiscard]] const std::vector<RecordedSource>& sources() const { return sources_; }
  [[nodiscard]] const RecordedCounts& counts() const { return counts_; }
  /// The newest description that the recording has of a component; null if there is none.
  [[nodiscard]] const ComponentDescription* FindComponent(const std::string& process,
                                                          const std::string& component) const;

  /// Empty at the end.
  std::optional<RecordedItem> Next();
  /// The next item is the first one again. The ticks go on.
  void Rewind();

 private:
  class Lane;
  class TableLane;
  class EventLane;
  class CommandLane;
  class LogLane;

  RecordingReader(mcap::Reader& reader, mcap::Query query);

  void MakeLanes();
  void ReadDescriptions();
  void Count();

  mcap::Reader& reader_;
  const mcap::Query query_;
  std::vector<RecordedSource> sources_;
  std::vector<std::unique_ptr<Lane>> lanes_;
  std::vector<mcap::ChannelId> left_out_;
  std::map<std::pair<std::string, std::string>, ComponentDescription> components_;
  RecordedCounts counts_;
};

}  // namespace tendon::recording
