#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>
#include <tendon/recording/mcap/reader.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tendon::recording {

/// The kind of the messages of a channel.
enum class Content {
  kRows,  ///< rows of a state table; a gap in the sequence is a loss
  kEvents,
  kCommands,  ///< calls
  kLog,       ///< records
  kOthers,    ///< messages of the recorder itself or of another program
};

/// The counts of an export.
struct ExportReport {
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;  ///< number of rows that are missing in the recording
  std::uint64_t events = 0;
  std::uint64_t commands = 0;  ///< calls
  std::uint64_t log = 0;       ///< records
  std::uint64_t others = 0;    ///< messages of other topics
  /// The number of entries that have a missing or malformed part. CSV files contain them with empty
  /// cells, so they are also counted above. HDF5 files do not contain them.
  std::uint64_t incomplete = 0;
  std::map<std::string, std::uint64_t> left_out;  ///< number of messages for each reason

  void Count(Content content);
};

/// Channels that an export writes into one table: the columns of one state table since one start of
/// its source, or a single event, command or other topic.
struct ChannelGroup {
  std::string path;  ///< "robot/arm/state"
  Content content = Content::kOthers;
  std::vector<const mcap::Channel*> channels;
};

/// Returns the groups of the channels of `query`, for the exports. Leaves out channels that do not
/// describe their values. Cost: one step for each channel; reads no message.
[[nodiscard]] std::vector<ChannelGroup> GroupsOf(const mcap::Reader& reader,
                                                 const mcap::Query& query);

/// One column of a table, an event, a command, or another topic.
struct ChannelMember {
  std::string name;  ///< empty if the topic has only one member
  Schema schema;
};

/// The types of ROS 2 messages that MemberOf() has parsed, by schema. They are stored because
/// channels may share a large schema.
using RosTypes = std::map<mcap::SchemaId, Result<Schema>>;

/// Returns the name and the type of a channel's values. The type is the Tendon schema or, in files
/// of other programs, the ROS 2 message (`ros2msg` and `cdr`). Fails with kInvalid if the channel
/// has neither, or if the text has a mistake.
[[nodiscard]] Result<ChannelMember> MemberOf(const mcap::Reader& reader,
                                             const mcap::Channel& channel, RosTypes& known);

/// Returns the publish time of a message minus its time on the steady clock of its source, in ns.
[[nodiscard]] std::int64_t ClockOf(const mcap::Channel& channel);
/// Returns the time on the steady clock of the source, in ns. `clock` is ClockOf() of its channel.
/// The sum wraps around if a hostile file has absurd numbers.
[[nodiscard]] std::int64_t SourceTimeOf(mcap::Timestamp publish_time, std::int64_t clock);

/// The number of messages that are not exported, by channel.
using LeftOut = std::map<mcap::ChannelId, std::uint64_t>;
/// Adds these messages to the report, with the reasons.
void CountLeftOut(const mcap::Reader& reader, const LeftOut& left_out, ExportReport& report);

/// The maximum number of columns of an export. A hostile file could have more than fit into memory.
constexpr std::size_t kMaxColumns = 1'000'000;
/// The error for a recording that has more columns.
[[nodiscard]] Error TooManyColumns(const mcap::Reader& reader);

/// The error for a recording that has nothing to export.
[[nodiscard]] Error NothingToExport(const mcap::Reader& reader);

}  // namespace tendon::recording
