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

/// The recorded members of a state table, or the recorded events or commands of an interface.
struct RecordedSource {
  InterfaceName name;
  std::vector<RecordedMember> members;
  bool is_table = false;
  bool are_commands = false;
  std::uint64_t first_tick = 0;    ///< only for a table
  std::uint64_t count = 0;         ///< rows, events or calls
  mcap::Timestamp first_time = 0;  ///< log time; 0 if there is none
  mcap::Timestamp last_time = 0;
};

/// A row of a table. Its ticks only increase: if the source was restarted, the ticks in the file
/// start again at the beginning, but the ticks of these rows continue.
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
  mcap::Timestamp time = 0;  ///< the log time; for a call, the end of its execution
  std::size_t source = 0;    ///< index of RecordingReader::sources(); not for the log
  std::variant<RecordedRow, RecordedEvent, RosLog> content;
};

/// The counts of RecordingReader::Open().
struct RecordedCounts {
  std::uint64_t rows = 0;
  std::uint64_t events = 0;
  std::uint64_t commands = 0;  ///< calls
  std::uint64_t log = 0;       ///< records
  /// The number of messages that are left out, because their channels were not written by Tendon or
  /// the type of their path has changed.
  std::uint64_t left_out = 0;
  mcap::Timestamp first_time = 0;
  mcap::Timestamp last_time = 0;
};

/// Reads a recording as rows, events, calls and log records, in the order of their times. The
/// replay uses it; RecordingWriter is its counterpart. The rows of one table, and the events of one
/// interface, keep the order of the file.
///
///     auto recording = RecordingReader::Open(*reader, query);
///     while (auto item = (*recording)->Next()) Play(*item);
///
/// Cost: Open() reads the part once, to find the sizes of all values. Memory: one item for each
/// source, and the memory of the MCAP reader.
///
/// Thread safety: one thread at a time may use this object and the MCAP reader, which must outlive
/// it.
class RecordingReader {
 public:
  static constexpr std::size_t kMaxSources = 4096;

  /// Reads the messages that match; ignores the order in `query`. Fails with kInvalid if the part
  /// contains no row, event or call that can be read, or more than kMaxSources tables and
  /// interfaces.
  static Result<std::unique_ptr<RecordingReader>> Open(mcap::Reader& reader, mcap::Query query);
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;
  ~RecordingReader();

  [[nodiscard]] const std::vector<RecordedSource>& sources() const { return sources_; }
  [[nodiscard]] const RecordedCounts& counts() const { return counts_; }
  /// Returns the newest description of a component in the recording; null if there is none.
  [[nodiscard]] const ComponentDescription* FindComponent(const std::string& process,
                                                          const std::string& component) const;

  /// Returns the next item, or nothing at the end.
  std::optional<RecordedItem> Next();
  /// Returns to the beginning: the next item is the first one. The ticks continue to increase.
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
