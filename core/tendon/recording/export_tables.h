#pragma once

#include <tendon/base/os/part_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/row_assembler.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tendon::recording {

/// The tables that an export writes, and the table of each channel. Groups of channels with the
/// same path and the same members share a table. `Table` is defined by the export: a file, or a
/// part of one.
///
/// Thread safety: one thread at a time.
template <typename Table>
class ExportTables {
 public:
  /// Where the messages of a channel go.
  struct Destination {
    std::shared_ptr<Table> table;
    std::size_t column = 0;
    std::int64_t clock = 0;   ///< ClockOf() of the channel
    mcap::ChannelId run = 0;  ///< as in RowKey
  };
  /// Makes the table of a group.
  using Make = std::function<Result<std::shared_ptr<Table>>(const ChannelGroup& group,
                                                            const std::vector<ChannelMember>&)>;

  /// Adds a group, without the channels that do not describe their values. Calls `make` if no group
  /// with the same path and members was added before; fails if `make` fails.
  Result<void> Add(const mcap::Reader& reader, const ChannelGroup& group, const Make& make) {
    std::string signature = group.path;
    std::vector<ChannelMember> members;
    std::vector<const mcap::Channel*> channels;
    for (const mcap::Channel* channel : group.channels) {
      const auto member = MemberOf(reader, *channel, known_);
      if (!member) continue;
      const auto type = types_.emplace(member->schema.TextWithHelp(), types_.size()).first;
      signature += '\n' + member->name + ' ' + std::to_string(type->second);
      members.push_back(*member);
      channels.push_back(channel);
    }
    if (channels.empty()) return {};
    auto& table = tables_[signature];
    if (!table) {
      auto made = make(group, members);
      if (!made) return made.error();
      table = *std::move(made);
      all_.push_back(table);
    }
    for (std::size_t i = 0; i < channels.size(); ++i) {
      destinations_[channels[i]->id] = {table, i, ClockOf(*channels[i]), channels.front()->id};
    }
    return {};
  }

  /// The tables in the order in which they were made.
  [[nodiscard]] const std::vector<std::shared_ptr<Table>>& all() const { return all_; }

  /// Calls `add(destination, key, message)` for each message that matches, until it fails. Counts
  /// messages without a destination in `report`. If `stop` returns true, fails with
  /// os::StoppedError(place).
  template <typename AddMessage>
  Result<void> AddMessages(mcap::Reader& reader, const mcap::Query& query,
                           const std::filesystem::path& place, const os::StopRequest& stop,
                           ExportReport& report, const AddMessage& add) const {
    constexpr std::uint64_t kBetweenLooks = 1024;
    LeftOut left_out;
    std::uint64_t count = 0;
    mcap::MessageStream messages = reader.Messages(query);
    while (const auto message = messages.Next()) {
      if (++count % kBetweenLooks == 0 && stop && stop()) return os::StoppedError(place);
      const auto found = destinations_.find(message->channel_id);
      if (found == destinations_.end()) {
        ++left_out[message->channel_id];
        continue;
      }
      const RowKey key{message->log_time, message->sequence, found->second.run};
      if (Result<void> added = add(found->second, key, *message); !added) return added;
    }
    CountLeftOut(reader, left_out, report);
    return {};
  }

 private:
  std::map<std::string, std::shared_ptr<Table>> tables_;  // by path and members
  std::vector<std::shared_ptr<Table>> all_;
  std::map<mcap::ChannelId, Destination> destinations_;
  RosTypes known_;
  std::map<std::string, std::size_t> types_;  // their numbers, by their text
};

/// Makes the tables of these groups. Fails if `make` fails or if there is no table; fails with
/// os::StoppedError(place) if `stop` returns true.
template <typename Table>
Result<ExportTables<Table>> MakeTables(const mcap::Reader& reader,
                                       const std::vector<ChannelGroup>& groups,
                                       const std::filesystem::path& place,
                                       const os::StopRequest& stop,
                                       const typename ExportTables<Table>::Make& make) {
  ExportTables<Table> tables;
  for (const ChannelGroup& group : groups) {
    if (stop && stop()) return os::StoppedError(place);
    if (auto added = tables.Add(reader, group, make); !added) return added.error();
  }
  if (tables.all().empty()) return NothingToExport(reader);
  return tables;
}

/// Makes the names of the tables unique: the second "state" is "state-2".
class TableNames {
 public:
  std::string Take(const std::string& name, const std::string& suffix = "") {
    std::string unique = name + suffix;
    for (int i = 2; !taken_.insert(unique).second; ++i) {
      unique = name + "-" + std::to_string(i) + suffix;
    }
    return unique;
  }

 private:
  std::set<std::string> taken_;
};

}  // namespace tendon::recording
