#include <tendon/recording/playback.h>

#include <tendon/base/path.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/fingerprint.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <set>
#include <string_view>

namespace tendon::recording {
namespace {

/// The maximum size in bytes of the message indexes that Spans() reads.
constexpr std::uint64_t kMaxIndexed = std::uint64_t{16} << 20U;
/// The number of chunks that are searched for the newest value of a column.
constexpr std::size_t kMaxSearched = 64;
/// A day before the latest time that fits in a signed 64-bit number, so that sums of times fit,
/// too.
constexpr mcap::Timestamp kLatestTime =
    static_cast<mcap::Timestamp>(std::numeric_limits<std::int64_t>::max()) - 86'400'000'000'000;

std::uint64_t NumberOf(const std::string& text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// `channels` are sorted.
bool Contains(const mcap::MessageBlock& block, const std::vector<mcap::ChannelId>& channels) {
  const auto& known = block.index.message_index_offsets;
  if (known.empty()) return true;
  return std::ranges::any_of(
      known, [&](const auto& one) { return std::ranges::binary_search(channels, one.first); });
}

void Append(std::vector<mcap::ChannelId>& to, const std::vector<mcap::ChannelId>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Searches backwards through the file, in pieces. Calls `visit` with a stream of the messages of
/// `channels` in the latest piece up to `until`, then in the piece before it, and so on, until
/// `visit` returns true, or until it was called `most` times. `blocks` are sorted by their end,
/// latest first. `visit` may remove some of `channels`; pieces that contain only these are then
/// neither read nor counted.
template <typename Visit>
void SearchBack(mcap::Reader& reader, const std::vector<const mcap::MessageBlock*>& blocks,
                mcap::Timestamp until, const std::vector<mcap::ChannelId>& channels,
                std::size_t most, Visit visit) {
  std::size_t count = 0;
  for (const mcap::MessageBlock* block : blocks) {
    const mcap::Timestamp from = block->index.message_start_time;
    if (from > until || !Contains(*block, channels)) continue;
    mcap::MessageStream messages =
        reader.Messages({.from = from, .to = until, .channels = channels});
    if (visit(messages) || ++count == most || from == 0) return;
    until = from - 1;
  }
}

}  // namespace

Playback::Playback(std::unique_ptr<mcap::Reader> reader) : reader_(std::move(reader)) {}

Result<std::unique_ptr<Playback>> Playback::Open(std::unique_ptr<mcap::Reader> reader) {
  std::unique_ptr<Playback> playback(new Playback(std::move(reader)));
  if (auto found = playback->FindChannels(); !found) return found.error();
  if (auto found = playback->FindTimes(); !found) return found.error();
  playback->position_ = playback->first_time_ - 1;
  if (playback->catalogues_.empty()) playback->MakeCatalogue();
  return playback;
}

Result<void> Playback::FindChannels() {
  for (const auto& [id, channel] : reader_->channels()) {
    if (channel.topic == kLogTopic && MetadataValue(channel, kKindKey) == kOtherKind) {
      log_.push_back(id);
    } else if (channel.topic == kLossTopic) {
      losses_.push_back(id);
    } else if (channel.topic == kCatalogueTopic) {
      catalogues_.push_back(id);
    } else {
      const std::string kind = MetadataValue(channel, kKindKey);
      const auto path = ParsePath(MetadataValue(channel, kPathKey));
      const auto schema = Schema::Parse(MetadataValue(channel, kSchemaKey));
      const bool is_known = kind == kColumnKind || kind == kEventKind;
      if (!is_known || !path || path->member.empty() || !schema) continue;
      const bool is_event = kind == kEventKind;
      const std::string text = ToString(*path);
      channels_[id] = {text, *schema, NumberOf(MetadataValue(channel, kEpochKey)), is_event};
      (is_event ? events_ : columns_[text]).push_back(id);
    }
  }
  if (!channels_.empty() || !catalogues_.empty() || !log_.empty()) return {};
  return Error{ErrorCode::kInvalid, reader_->name() +
                                        " contains no table, event or log that Tendon recorded; to "
                                        "list what it contains: gcm info FILE"};
}

Result<void> Playback::FindTimes() {
  first_time_ = mcap::kLastTime;
  for (const mcap::MessageBlock& block : reader_->blocks()) {
    if (block.index.message_end_time == 0) continue;  // it has no message
    first_time_ = std::min(first_time_, block.index.message_start_time);
    last_time_ = std::max(last_time_, block.index.message_end_time);
  }
  if (last_time_ == 0) {
    return Error{ErrorCode::kInvalid,
                 reader_->name() + " contains no message; if it is still being written, open it " +
                     "again later"};
  }
  if (last_time_ > kLatestTime) {
    return Error{ErrorCode::kInvalid,
                 reader_->name() + " has a message at " + std::to_string(last_time_) +
                     " ns since 1970; the latest time that can be played is " +
                     std::to_string(kLatestTime) +
                     "; to leave such messages out: gcm cut FILE -o PART --to TIME"};
  }
  first_time_ = std::max<mcap::Timestamp>(1, std::min(first_time_, last_time_));
  return {};
}

void Playback::MakeCatalogue() {
  std::map<std::string, std::map<std::string, ComponentDescription>> processes;
  for (const auto& [text, ids] : columns_) {
    const auto path = ParsePath(text);
    ComponentDescription& component = processes[path->process][path->component];
    component.name = path->component;
    component.state = ComponentState::kActive;
    if (component.tables.empty() || component.tables.back().name != path->interface) {
      component.tables.push_back({.name = path->interface, .length = 0, .columns = {}});
    }
    const Schema& schema = channels_.at(ids.back()).schema;
    component.tables.back().columns.push_back(
        {path->member, schema.TypeName(), payload::Remember(schema)});
  }
  const auto apply = [this](CatalogueChange change) {
    change.revision = made_catalogue_.revision() + 1;
    (void)made_catalogue_.Apply(change);
  };
  for (const auto& [process, components] : processes) {
    CatalogueChange joined;
    joined.process = process;
    joined.processes.push_back({.name = process, .host = {}, .address = {}, .reason = {}});
    apply(std::move(joined));
    for (const auto& [name, component] : components) {
      CatalogueChange added;
      added.kind = CatalogueChange::Kind::kComponent;
      added.process = process;
      added.components.push_back(component);
      apply(std::move(added));
    }
  }
}

std::vector<std::string> Playback::columns() const {
  std::vector<std::string> paths;
  for (const auto& [path, ids] : columns_) paths.push_back(path);
  return paths;
}

const Schema* Playback::FindSchema(const std::string& column) const {
  const auto found = columns_.find(column);
  return found == columns_.end() ? nullptr : &channels_.at(found->second.back()).schema;
}

std::vector<Schema> Playback::types() const {
  std::vector<Schema> types;
  std::set<Fingerprint> known;
  for (const auto& [id, channel] : channels_) {
    if (known.insert(channel.schema.fingerprint()).second) types.push_back(channel.schema);
  }
  return types;
}

const Playback::Channels& Playback::ChannelsOf(Kind kind) const {
  return kind == Kind::kEvents ? events_ : losses_;
}

Playback::Channels Playback::ChannelsOf(const std::vector<std::string>& columns) const {
  Channels channels;
  for (const std::string& path : columns) {
    const auto found = columns_.find(path);
    if (found != columns_.end()) Append(channels, found->second);
  }
  std::ranges::sort(channels);
  return channels;
}

Playback::Channels Playback::StepChannels() const {
  Channels channels = chosen_;
  Append(channels, events_);
  for (const auto& [path, ids] : columns_) {
    if (chosen_.empty()) Append(channels, ids);
  }
  std::ranges::sort(channels);
  return channels;
}

Playback::Channels Playback::PlayedChannels() const {
  Channels channels = chosen_;
  for (const Channels* always : {&events_, &losses_, &log_, &catalogues_}) {
    Append(channels, *always);
  }
  return channels;
}

void Playback::Choose(const std::vector<std::string>& columns) {
  chosen_ = ChannelsOf(columns);
  Seek(position_);
}

void Playback::Seek(mcap::Timestamp time) {
  position_ = time;
  stream_.reset();
  next_.reset();
}

void Playback::PlayUpTo(mcap::Timestamp time, const Handler& handler) {
  if (time <= position_) return;
  if (!stream_) {
    const Channels channels = PlayedChannels();
    // An empty list would mean all channels.
    if (channels.empty()) return Seek(time);
    stream_.emplace(reader_->Messages({.from = position_ + 1, .channels = channels}));
  }
  position_ = time;
  if (next_) {
    if (next_->message.log_time > time) return;
    HandOut(next_->message, handler);
    next_.reset();
  }
  while (const auto message = stream_->Next()) {
    if (message->log_time <= time) {
      HandOut(*message, handler);
      continue;
    }
    next_.emplace(OwnMessage{*message, {message->data.begin(), message->data.end()}});
    next_->message.data = next_->data;
    return;
  }
}

void Playback::HandOut(const mcap::Message& message, const Handler& handler) const {
  const mcap::ByteView body = BodyOf(message.data);
  const auto is_one_of = [&](const Channels& channels) {
    return std::ranges::count(channels, message.channel_id) > 0;
  };
  const auto hand_out = [&](auto content) { handler({message.log_time, std::move(content)}); };
  const auto decode = [&](auto content) {
    if (Decode(body, content)) hand_out(std::move(content));
  };
  if (const auto found = channels_.find(message.channel_id); found != channels_.end()) {
    const PlayedChannel& channel = found->second;
    if (channel.is_event) return hand_out(PlayedEvent{&channel, body});
    return hand_out(PlayedValue{&channel, message.sequence, body});
  }
  if (is_one_of(log_)) return decode(RosLog{});
  if (is_one_of(losses_)) return decode(Loss{});
  CatalogueChange change;
  if (Decode(body, change)) hand_out(PlayedChange{std::move(change), message.sequence == 0});
}

void Playback::ReadChangesUpTo(mcap::Timestamp time) {
  if (has_all_changes_ || (!changes_.empty() && changes_.back().first > time)) return;
  if (!change_stream_) change_stream_.emplace(reader_->Messages({.channels = catalogues_}));
  while (const auto message = change_stream_->Next()) {
    HandOut(*message, [this](const PlayedItem& item) {
      changes_.emplace_back(item.time, std::get<PlayedChange>(item.content));
    });
    if (!changes_.empty() && changes_.back().first > time) return;
  }
  has_all_changes_ = true;
}

Catalogue Playback::CatalogueNow() {
  if (catalogues_.empty()) return made_catalogue_;
  ReadChangesUpTo(position_);
  Catalogue catalogue;
  if (changes_.empty()) return catalogue;
  ReadChangesUpTo(changes_.front().first);  // all of the first snapshot
  const mcap::Timestamp until = std::max(position_, changes_.front().first);
  for (const auto& [time, played] : changes_) {
    if (time > until) break;
    if (played.begins_snapshot) catalogue = Catalogue::At(played.change.revision - 1);
    (void)catalogue.Apply(played.change);
  }
  return catalogue;
}

void Playback::Past(const std::vector<std::string>& columns, mcap::Timestamp from,
                    WithLosses losses, const Handler& handler) {
  std::vector<std::string> missing = columns;
  std::erase_if(missing, [this](const std::string& path) { return !columns_.contains(path); });
  if (missing.empty()) return;
  Channels channels = ChannelsOf(missing);
  if (losses == WithLosses::kYes) Append(channels, losses_);
  mcap::MessageStream messages =
      reader_->Messages({.from = from, .to = position_, .channels = std::move(channels)});
  const PlayedChannel* latest = nullptr;
  while (const auto message = messages.Next()) {
    HandOut(*message, handler);
    const auto found = channels_.find(message->channel_id);
    if (found == channels_.end() || &found->second == latest) continue;
    latest = &found->second;
    std::erase(missing, latest->path);
  }
  if (missing.empty() || from == 0) return;
  Channels left = ChannelsOf(missing);
  SearchBack(*reader_, BlocksBefore(left, from - 1), from - 1, left, kMaxSearched,
             [&](mcap::MessageStream& piece) {
               std::map<std::string, OwnMessage> newest;
               while (const auto message = piece.Next()) {
                 OwnMessage& own = newest[channels_.at(message->channel_id).path];
                 own = {*message, {message->data.begin(), message->data.end()}};
                 own.message.data = own.data;
               }
               for (const auto& [path, own] : newest) {
                 HandOut(own.message, handler);
                 std::erase(missing, path);
               }
               left = ChannelsOf(missing);
               return missing.empty();
             });
}

std::vector<const mcap::MessageBlock*> Playback::BlocksBefore(const Channels& channels,
                                                              mcap::Timestamp time) const {
  std::vector<const mcap::MessageBlock*> blocks;
  for (const mcap::MessageBlock& block : reader_->blocks()) {
    const bool is_empty = block.index.message_end_time == 0;
    if (is_empty || block.index.message_start_time > time || !Contains(block, channels)) continue;
    blocks.push_back(&block);
  }
  std::ranges::stable_sort(blocks, std::ranges::greater(), [](const mcap::MessageBlock* block) {
    return block->index.message_end_time;
  });
  return blocks;
}

void Playback::Last(const Channels& channels, std::size_t most, const Handler& handler) {
  if (channels.empty()) return;
  std::vector<OwnMessage> found;
  SearchBack(*reader_, BlocksBefore(channels, position_), position_, channels, kMaxSearched,
             [&](mcap::MessageStream& piece) {
               std::vector<OwnMessage> here;
               while (const auto message = piece.Next()) {
                 here.push_back({*message, {message->data.begin(), message->data.end()}});
               }
               found.insert(found.begin(), std::make_move_iterator(here.begin()),
                            std::make_move_iterator(here.end()));
               return found.size() >= most;
             });
  const std::size_t first = found.size() - std::min(found.size(), most);
  for (std::size_t i = first; i < found.size(); ++i) {
    found[i].message.data = found[i].data;
    HandOut(found[i].message, handler);
  }
}

void Playback::LastEvents(std::size_t most, const Handler& handler) {
  Last(events_, most, handler);
}

void Playback::LastLog(std::size_t most, const Handler& handler) { Last(log_, most, handler); }

std::optional<mcap::Timestamp> Playback::Next(const Channels& channels, mcap::Timestamp time) {
  if (channels.empty()) return std::nullopt;
  mcap::MessageStream messages =
      reader_->Messages({.from = time + 1, .to = last_time_, .channels = channels});
  const auto next = messages.Next();
  return next ? std::optional(next->log_time) : std::nullopt;
}

std::optional<mcap::Timestamp> Playback::Previous(const Channels& channels, mcap::Timestamp time) {
  if (channels.empty() || time == 0) return std::nullopt;
  std::optional<mcap::Timestamp> last;
  SearchBack(*reader_, BlocksBefore(channels, time - 1), time - 1, channels,
             reader_->blocks().size(), [&](mcap::MessageStream& piece) {
               while (const auto message = piece.Next()) last = message->log_time;
               return last.has_value();
             });
  return last;
}

std::optional<mcap::Timestamp> Playback::NextStep() { return Next(StepChannels(), position_); }

std::optional<mcap::Timestamp> Playback::PreviousStep() {
  return Previous(StepChannels(), position_);
}

std::optional<mcap::Timestamp> Playback::FindNext(Kind kind, mcap::Timestamp time) {
  return Next(ChannelsOf(kind), time);
}

std::optional<mcap::Timestamp> Playback::FindPrevious(Kind kind, mcap::Timestamp time) {
  return Previous(ChannelsOf(kind), time);
}

std::vector<PlayedSpan> Playback::Spans(Kind kind) {
  const Channels& channels = ChannelsOf(kind);
  std::vector<PlayedSpan> spans;
  if (channels.empty()) return spans;
  const auto blocks = BlocksBefore(channels, mcap::kLastTime);
  std::uint64_t size = 0;
  for (const mcap::MessageBlock* block : blocks) size += block->index.message_index_length;
  for (const mcap::MessageBlock* block : blocks) {
    const PlayedSpan whole{block->index.message_start_time, block->index.message_end_time};
    const bool is_indexed = size <= kMaxIndexed && block->is_chunk;
    const auto indexes =
        is_indexed ? reader_->ReadMessageIndexes(*block)
                   : Result<std::vector<mcap::MessageIndex>>(Error{ErrorCode::kNotFound, {}});
    if (!indexes) {
      spans.push_back(whole);
      continue;
    }
    for (const mcap::MessageIndex& index : *indexes) {
      if (!std::ranges::binary_search(channels, index.channel_id)) continue;
      for (const auto& entry : index.records) {
        if (entry.log_time > last_time_) continue;  // an index has no checksum
        spans.push_back({entry.log_time, entry.log_time});
      }
    }
  }
  std::ranges::sort(spans, {}, [](const PlayedSpan& span) { return span.from; });
  return spans;
}

}  // namespace tendon::recording
