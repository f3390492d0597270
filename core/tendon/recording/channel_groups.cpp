#include <tendon/recording/channel_groups.h>

#include <tendon/base/text.h>
#include <tendon/payload/schema/ros_parser.h>
#include <tendon/recording/recording_format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

namespace tendon::recording {
namespace {

bool IsColumn(const mcap::Channel& channel) {
  return MetadataValue(channel, kKindKey) == kColumnKind;
}

Content ContentOf(const mcap::Channel& channel) {
  const std::string kind = MetadataValue(channel, kKindKey);
  if (kind == kColumnKind) return Content::kRows;
  if (kind == kEventKind) return Content::kEvents;
  if (kind == kCommandKind) return Content::kCommands;
  return kind == kOtherKind && channel.topic == kLogTopic ? Content::kLog : Content::kOthers;
}

/// Null if the channel has no ROS 2 message.
const mcap::Schema* RosSchemaOf(const mcap::Reader& reader, const mcap::Channel& channel) {
  const auto schema = reader.schemas().find(channel.schema_id);
  const bool is_ros = channel.message_encoding == kMessageEncoding &&
                      schema != reader.schemas().end() &&
                      schema->second.encoding == kSchemaEncoding;
  return is_ros ? &schema->second : nullptr;
}

bool IsDescribed(const mcap::Reader& reader, const mcap::Channel& channel) {
  return !MetadataValue(channel, kSchemaKey).empty() || RosSchemaOf(reader, channel) != nullptr;
}

/// "json with a schema in jsonschema"
std::string EncodingText(const mcap::Reader& reader, const mcap::Channel& channel) {
  constexpr std::size_t kMax = 60;
  const auto schema = reader.schemas().find(channel.schema_id);
  std::string text = Quoted(channel.message_encoding, kMax);
  if (schema == reader.schemas().end()) return text + " without a schema";
  return text + " with a schema in " + Quoted(schema->second.encoding, kMax);
}

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
    if (!is_wanted || !IsDescribed(reader, channel)) continue;
    const bool is_column = IsColumn(channel);
    const std::string path =
        is_column ? channel.topic.substr(0, channel.topic.rfind('/')) : channel.topic;
    const std::string run = is_column ? MetadataValue(channel, kEpochKey) : std::to_string(id);
    auto& of_path = groups[{path, run}];
    // If a column occurs twice, the recorder has selected the columns of the table again.
    if (of_path.empty() || HasTopic(of_path.back(), channel.topic)) {
      of_path.push_back({path, ContentOf(channel), {}});
    }
    of_path.back().channels.push_back(&channel);
  }
  std::vector<ChannelGroup> all;
  for (auto& [key, of_path] : groups) {
    for (ChannelGroup& group : of_path) all.push_back(std::move(group));
  }
  return all;
}

Result<ChannelMember> MemberOf(const mcap::Reader& reader, const mcap::Channel& channel,
                               RosTypes& known) {
  const std::string text = MetadataValue(channel, kSchemaKey);
  const mcap::Schema* const ros = RosSchemaOf(reader, channel);
  if (text.empty() && ros == nullptr) {
    return Error{ErrorCode::kInvalid, "their encoding is " + EncodingText(reader, channel) +
                                          ", and only 'cdr' with a schema in 'ros2msg' is read"};
  }
  const auto parsed = [&] {
    const auto found = known.find(channel.schema_id);
    if (found != known.end()) return found->second;
    return known.emplace(channel.schema_id, ParseRosMessage(ros->name, ros->data)).first->second;
  };
  const auto schema = text.empty() ? parsed() : Schema::Parse(text);
  if (!schema) {
    constexpr std::size_t kMax = 200;
    return Error{ErrorCode::kInvalid,
                 "their type cannot be read: " + Printable(schema.error().message, kMax)};
  }
  const std::string name =
      IsColumn(channel) ? channel.topic.substr(channel.topic.rfind('/') + 1) : "";
  return ChannelMember{name, *schema};
}

std::int64_t ClockOf(const mcap::Channel& channel) {
  const std::string text = MetadataValue(channel, kClockKey);
  std::int64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::int64_t SourceTimeOf(mcap::Timestamp publish_time, std::int64_t clock) {
  return static_cast<std::int64_t>(publish_time - static_cast<std::uint64_t>(clock));
}

void ExportReport::Count(Content content) {
  switch (content) {
    case Content::kRows:
      ++rows;
      break;
    case Content::kEvents:
      ++events;
      break;
    case Content::kCommands:
      ++commands;
      break;
    case Content::kLog:
      ++log;
      break;
    case Content::kOthers:
      ++others;
      break;
  }
}

void CountLeftOut(const mcap::Reader& reader, const LeftOut& left_out, ExportReport& report) {
  RosTypes known;
  for (const auto& [id, count] : left_out) {
    const mcap::Channel* const channel = reader.FindChannel(id);
    const auto member = channel == nullptr
                            ? Result<ChannelMember>(Error{ErrorCode::kInvalid, "no channel"})
                            : MemberOf(reader, *channel, known);
    report.left_out[member ? "their channel is not in the index of the file; gcm recover makes "
                             "another index"
                           : member.error().message] += count;
  }
}

Error TooManyColumns(const mcap::Reader& reader) {
  return {ErrorCode::kInvalid, "the chosen part of " + reader.name() + " has more than " +
                                   std::to_string(kMaxColumns) +
                                   " columns; choose a smaller part with --paths"};
}

Error NothingToExport(const mcap::Reader& reader) {
  return {ErrorCode::kInvalid,
          "no channel of " + reader.name() +
              " that was chosen has a description of its values, which is a Tendon schema or a ROS "
              "2 message in CDR; to list the channels: gcm info FILE"};
}

}  // namespace tendon::recording
