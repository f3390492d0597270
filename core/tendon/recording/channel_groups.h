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
  kRows,  ///< of a state table; a sequence that is missing was lost
  kEvents,
  kCommands,  ///< calls
  kLog,       ///< records
  kOthers,    ///< of the recorder itself, or of another program
};

/// What an export has written.
struct ExportReport {
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;  ///< rows that are missing between them
  std::uint64_t events = 0;
  std::uint64_t commands = 0;  ///< calls
  std::uint64_t log = 0;       ///< records
  std::uint64_t others = 0;    ///< messages of other topics
  /// Entries of which a part is missing or malformed. CSV has them with empty cells, so they count
  /// above, too; HDF5 leaves them out.
  std::uint64_t incomplete = 0;
  std::map<std::string, std::uint64_t> left_out;  ///< messages, by the reason

  void Count(Content content);
};

/// Channels that an export writes side by side: the columns of one table since one start of its
/// source, or a single event, command or other topic.
struct ChannelGroup {
  std::string path;  ///< "robot/arm/state"
  Content content = Content::kOthers;
  std::vector<const mcap::Channel*> channels;
};

/// Returns the groups of the channels of `query`, for the exports. Leaves out channels that do not
/// describe their values. Cost: one look at each channel; reads no message.
[[nodiscard]] std::vector<ChannelGroup> GroupsOf(const mcap::Reader& reader,
                                                 const mcap::Query& query);

/// One column of a table, an event, a command, or another topic.
struct ChannelMember {
  std::string name;  ///< empty if the topic has only this one
  Schema schema;
};

/// The types of ROS 2 messages that MemberOf() has parsed, by schema: channels may share a large
/// one.
using RosTypes = std::map<mcap::SchemaId, Result<Schema>>;

/// Returns the name and the type of a channel's values. The type is the Tendon schema, or else the
/// ROS 2 message (`ros2msg` and `cdr`), which files of other programs have, too. kInvalid, with a
/// sentence, if the channel has neither or the text is broken.
[[nodiscard]] Result<ChannelMember> MemberOf(const mcap::Reader& reader,
                                             const mcap::Channel& channel, RosTypes& known);

/// Returns the publish time of a message minus its time on the steady clock of its source, ns.
[[nodiscard]] std::int64_t ClockOf(const mcap::Channel& channel);
/// Returns the time on the steady clock of the source, ns. `clock` is ClockOf() its channel.
/// Numbers of a hostile file may wrap around.
[[nodiscard]] std::int64_t SourceTimeOf(mcap::Timestamp publish_time, std::int64_t clock);

/// Messages that are not exported, by their channel.
using LeftOut = std::map<mcap::ChannelId, std::uint64_t>;
/// Adds them to the report, with the reasons.
void CountLeftOut(const mcap::Reader& reader, const LeftOut& left_out, ExportReport& report);

/// Columns of all tables of an export. A hostile file could have so many that no memory holds them.
constexpr std::size_t kMostColumns = 1'000'000;
/// The error for a part of a recording that has more.
[[nodiscard]] Error TooManyColumns(const mcap::Reader& reader);

/// The error for a recording that has nothing to export.
[[nodiscard]] Error NothingToExport(const mcap::Reader& reader);

}  // namespace tendon::recording
