#include <tendon/recording/channel_groups.h>
#include <tendon/recording/recording_files.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

namespace tendon::recording {
namespace {

/// The value of a key, or an empty text.
std::string TextOf(const mcap::Channel& channel, const char* key) {
  const auto found = channel.metadata.find(key);
  return found == channel.metadata.end() ? "" : found->second;
}

bool IsColumn(const mcap::Channel& channel) { return TextOf(channel, kKindKey) == "column"; }

bool HasTopic(const ChannelGroup& group, const std::string& topic) {
  return std::ranges::any_of(group.channels,
                             [&](const mcap::Channel* channel) { return channel->topic == topic; });
}

}  // namespace

std::vector<ChannelGroup> GroupsOf(const mcap::Reader& reader, const mcap::Query& query) {
  std::map<std::pair<std::string, std::string>, std::vector<ChannelGroup>>
      groups;  // by path, epoch
  for (const auto& [id, channel] : reader.channels()) {
    const bool is_wanted = query.channels.empty() || std::ranges::count(query.channels, id) > 0;
    if (!is_wanted || TextOf(channel, kSchemaKey).empty()) continue;
    const bool is_column = IsColumn(channel);
    const std::string path =
        is_column ? channel.topic.substr(0, channel.topic.rfind('/')) : channel.topic;
    const std::string run = is_column ? TextOf(channel, kEpochKey) : std::to_string(id);
    auto& of_path = groups[{path, run}];
    // A column that comes again is of a later choice of columns.
    if (of_path.empty() || HasTopic(of_path.back(), channel.topic)) {
      of_path.push_back({path, is_column ? Sequence::kTick : Sequence::kOther, {}});
    }
    of_path.back().channels.push_back(&channel);
  }
  std::vector<ChannelGroup> all;
  for (auto& [key, of_path] : groups) {
    for (ChannelGroup& group : of_path) all.push_back(std::move(group));
  }
  return all;
}

std::optional<ChannelMember> MemberOf(const mcap::Channel& channel) {
  const auto schema = Schema::Parse(TextOf(channel, kSchemaKey));
  if (!schema) return std::nullopt;
  const std::string name =
      IsColumn(channel) ? channel.topic.substr(channel.topic.rfind('/') + 1) : "";
  return ChannelMember{name, *schema};
}

std::int64_t ClockOf(const mcap::Channel& channel) {
  const std::string text = TextOf(channel, kClockKey);
  std::int64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

Error NothingToExport(const mcap::Reader& reader) {
  return {
      ErrorCode::kInvalid,
      "no channel of " + reader.name() +
          " that was chosen has a description of its values; to list the channels: gcm info FILE"};
}

}  // namespace tendon::recording
