#include <tendon/recording/recording_reader.h>

#include <tendon/base/path.h>
#include <tendon/interface/observed_call.h>
#include <tendon/payload/codec.h>
#include <tendon/process/process_description.h>
#include <tendon/recording/row_assembler.h>

#include <algorithm>

namespace tendon::recording {
/// The messages of one source, in the order of the file. Times never go back.
class RecordingReader::Lane {
 public:
  /// A message that owns its body.
  struct OwnMessage {
    mcap::ChannelId channel = 0;
    std::uint32_t sequence = 0;
    mcap::Timestamp time = 0;
    mcap::Timestamp publish_time = 0;
    std::vector<std::byte> body;
  };

  /// The kind of the messages of a channel.
  struct ChannelPlace {
    std::size_t member = 0;
    std::uint64_t run = 0;  // a different number for each epoch of the source
  };

  explicit Lane(std::size_t source) : source_(source) {}
  Lane(const Lane&) = delete;
  Lane& operator=(const Lane&) = delete;
  virtual ~Lane() = default;

  void Add(mcap::ChannelId channel, ChannelPlace place) { places_[channel] = std::move(place); }

  /// Begins with the first message.
  void Begin(mcap::Reader& reader, mcap::Query query) {
    query.order = mcap::Query::Order::kFile;
    query.channels.clear();
    for (const auto& [channel, place] : places_) query.channels.push_back(channel);
    messages_.emplace(reader.Messages(std::move(query)));
    time_ = 0;
    BeginAgain();
    Fetch();
    Advance();
  }

  /// Starts again with the ticks of the file, as if no row had been read.
  virtual void ForgetTicks() {}

  /// The next item; null at the end.
  [[nodiscard]] const RecordedItem* head() const { return head_ ? &*head_ : nullptr; }
  RecordedItem Take() {
    RecordedItem taken = *std::move(head_);
    Advance();
    return taken;
  }

 protected:
  /// Makes the next item from message(), if it can be read, and advances to the next message.
  virtual std::optional<RecordedItem> Make() = 0;
  virtual void BeginAgain() {}
  [[nodiscard]] virtual mcap::Timestamp TimeOf(const mcap::Message& message) const {
    return message.log_time;
  }

  /// Null at the end.
  [[nodiscard]] OwnMessage* message() { return message_ ? &*message_ : nullptr; }
  [[nodiscard]] const ChannelPlace& place() const { return places_.at(message_->channel); }
  [[nodiscard]] std::size_t source() const { return source_; }
  void Fetch() {
    const auto next = messages_->Next();
    message_.reset();
    if (!next) return;
    const mcap::ByteView body = BodyOf(next->data);
    message_ = OwnMessage{next->channel_id,
                          next->sequence,
                          TimeOf(*next),
                          next->publish_time,
                          {body.begin(), body.end()}};
  }

 private:
  void Advance() {
    head_.reset();
    while (message_ && !head_) head_ = Make();
    if (!head_) return;
    time_ = std::max(time_, head_->time);
    head_->time = time_;
  }

  const std::size_t source_;
  std::map<mcap::ChannelId, ChannelPlace> places_;
  std::optional<mcap::MessageStream> messages_;
  std::optional<OwnMessage> message_;
  std::optional<RecordedItem> head_;
  mcap::Timestamp time_ = 0;
};

/// The rows of one table.
class RecordingReader::TableLane final : public Lane {
 public:
  TableLane(std::size_t source, const std::vector<RecordedSource>& sources)
      : Lane(source), sources_(sources) {}

 private:
  void ForgetTicks() override { last_tick_.reset(); }
  std::optional<RecordedItem> Make() override {
    RowAssembler rows(sources_[source()].members.size());
    const auto key = [this] { return RowKey{message()->time, message()->sequence, place().run}; };
    while (message() != nullptr && rows.Accepts(place().member, key())) {
      rows.Add(place().member, key(), message()->publish_time, std::move(message()->body));
      Fetch();
    }
    AssembledRow assembled = rows.Take();
    RecordedRow row{.tick = TickOf(assembled.key), .cells = {}};
    for (auto& cell : assembled.cells)
      row.cells.push_back(std::move(cell).value_or(mcap::Buffer()));
    return RecordedItem{assembled.key.time, source(), std::move(row)};
  }
  void BeginAgain() override { last_.reset(); }

  /// The file has the low 32 bits of each tick.
  std::uint64_t TickOf(const RowKey& key) {
    const std::uint64_t tick =
        last_tick_ ? *last_tick_ + 1 + MissingRowsBetween(last_, key) : key.sequence;
    last_ = key;
    last_tick_ = tick;
    return tick;
  }

  const std::vector<RecordedSource>& sources_;
  std::optional<RowKey> last_;
  std::optional<std::uint64_t> last_tick_;
};

class RecordingReader::EventLane : public Lane {
 public:
  using Lane::Lane;

 private:
  std::optional<RecordedItem> Make() override {
    RecordedItem item{message()->time, source(),
                      RecordedEvent{place().member, std::move(message()->body)}};
    Fetch();
    return item;
  }
};

/// The calls of the commands of one interface. A call is known when its execution has ended.
class RecordingReader::CommandLane final : public EventLane {
 public:
  using EventLane::EventLane;

 private:
  [[nodiscard]] mcap::Timestamp TimeOf(const mcap::Message& message) const override {
    return message.log_time +
           static_cast<mcap::Timestamp>(HeaderOfCall(BodyOf(message.data)).took.count());
  }
};

class RecordingReader::LogLane final : public Lane {
 public:
  LogLane() : Lane(0) {}

 private:
  std::optional<RecordedItem> Make() override {
    RosLog record;
    const bool is_good = Decode(message()->body, record);
    const mcap::Timestamp time = message()->time;
    Fetch();
    if (!is_good) return std::nullopt;
    return RecordedItem{time, 0, std::move(record)};
  }
};

RecordingReader::RecordingReader(mcap::Reader& reader, mcap::Query query)
    : reader_(reader), query_(std::move(query)) {}

RecordingReader::~RecordingReader() = default;

Result<std::unique_ptr<RecordingReader>> RecordingReader::Open(mcap::Reader& reader,
                                                               mcap::Query query) {
  std::unique_ptr<RecordingReader> items(new RecordingReader(reader, std::move(query)));
  items->ReadDescriptions();
  items->MakeLanes();
  if (items->sources_.size() > kMaxSources) {
    return Error{ErrorCode::kInvalid, "the chosen part of " + reader.name() + " has " +
                                          std::to_string(items->sources_.size()) +
                                          " state tables and interfaces with events or "
                                          "commands, more than " +
                                          std::to_string(kMaxSources) +
                                          "; choose a smaller part with --paths"};
  }
  items->Count();
  const RecordedCounts& counts = items->counts_;
  if (counts.rows == 0 && counts.events == 0 && counts.commands == 0) {
    return Error{ErrorCode::kInvalid, "the chosen part of " + reader.name() +
                                          " has no row of a Tendon table, no event and no "
                                          "command; to list what the recording contains: gcm "
                                          "info FILE"};
  }
  for (const auto& lane : items->lanes_) lane->ForgetTicks();
  items->Rewind();
  return items;
}

void RecordingReader::MakeLanes() {
  std::map<std::pair<InterfaceName, std::string>, std::size_t> known;  // sources, with their kind
  std::map<std::string, std::uint64_t> runs;                           // by epoch
  std::unique_ptr<Lane> log = std::make_unique<LogLane>();
  bool has_log = false;
  for (const auto& [id, channel] : reader_.channels()) {
    if (!query_.channels.empty() && std::ranges::count(query_.channels, id) == 0) continue;
    if (channel.topic == kLogTopic && MetadataValue(channel, kKindKey) == kOtherKind) {
      log->Add(id, {});
      has_log = true;
      continue;
    }
    if (channel.topic == kLossTopic || channel.topic == kCatalogueTopic) continue;
    const std::string kind = MetadataValue(channel, kKindKey);
    const auto path = ParsePath(MetadataValue(channel, kPathKey));
    const auto schema = Schema::Parse(MetadataValue(channel, kSchemaKey));
    const bool is_known = kind == kColumnKind || kind == kEventKind || kind == kCommandKind;
    if (!is_known || !path || path->member.empty() || !schema) {
      left_out_.push_back(id);
      continue;
    }
    const auto [place, is_new] = known.try_emplace({path->interface_name(), kind}, sources_.size());
    if (is_new) {
      sources_.push_back({.name = path->interface_name(),
                          .members = {},
                          .is_table = kind == kColumnKind,
                          .are_commands = kind == kCommandKind});
      if (kind == kColumnKind) {
        lanes_.push_back(std::make_unique<TableLane>(place->second, sources_));
      } else if (kind == kCommandKind) {
        lanes_.push_back(std::make_unique<CommandLane>(place->second));
      } else {
        lanes_.push_back(std::make_unique<EventLane>(place->second));
      }
    }
    auto& members = sources_[place->second].members;
    const auto same = std::ranges::find(members, path->member, &RecordedMember::name);
    if (same != members.end() && !(same->schema == *schema)) {
      left_out_.push_back(id);
      continue;
    }
    const auto member = static_cast<std::size_t>(same - members.begin());
    if (same == members.end()) members.push_back({path->member, *schema});
    const auto run = runs.try_emplace(MetadataValue(channel, kEpochKey), runs.size()).first;
    lanes_[place->second]->Add(id, {member, run->second});
  }
  if (has_log) lanes_.push_back(std::move(log));
}

/// From all messages of the catalogue, including messages outside of the part.
void RecordingReader::ReadDescriptions() {
  mcap::Query query;
  query.order = mcap::Query::Order::kFile;
  for (const auto& [id, channel] : reader_.channels()) {
    if (channel.topic == kCatalogueTopic) query.channels.push_back(id);
  }
  if (query.channels.empty()) return;
  mcap::MessageStream messages = reader_.Messages(std::move(query));
  while (const auto message = messages.Next()) {
    CatalogueChange change;
    if (!Decode(BodyOf(message->data), change)) continue;
    for (ComponentDescription& component : change.components) {
      std::pair key(change.process, component.name);
      components_[std::move(key)] = std::move(component);
    }
  }
}

void RecordingReader::Count() {
  Rewind();
  while (const auto item = Next()) {
    if (counts_.first_time == 0) counts_.first_time = item->time;
    counts_.last_time = item->time;
    if (std::holds_alternative<RosLog>(item->content)) {
      ++counts_.log;
      continue;
    }
    RecordedSource& source = sources_[item->source];
    const auto note = [](RecordedMember& member, const std::vector<std::byte>& value) {
      member.largest = std::max(member.largest, value.size());
    };
    if (const auto* row = std::get_if<RecordedRow>(&item->content)) {
      ++counts_.rows;
      if (source.count == 0) source.first_tick = row->tick;
      for (std::size_t i = 0; i < row->cells.size(); ++i) note(source.members[i], row->cells[i]);
    } else {
      ++(source.are_commands ? counts_.commands : counts_.events);
      const auto& event = std::get<RecordedEvent>(item->content);
      note(source.members[event.event], event.value);
    }
    if (source.count++ == 0) source.first_time = item->time;
    source.last_time = item->time;
  }
  if (left_out_.empty()) return;
  mcap::Query query = query_;
  query.order = mcap::Query::Order::kFile;
  query.channels = left_out_;
  mcap::MessageStream messages = reader_.Messages(std::move(query));
  while (messages.Next()) ++counts_.left_out;
}

const ComponentDescription* RecordingReader::FindComponent(const std::string& process,
                                                           const std::string& component) const {
  const auto found = components_.find({process, component});
  return found == components_.end() ? nullptr : &found->second;
}

std::optional<RecordedItem> RecordingReader::Next() {
  Lane* next = nullptr;
  for (const auto& lane : lanes_) {
    if (lane->head() == nullptr) continue;
    if (next == nullptr || lane->head()->time < next->head()->time) next = lane.get();
  }
  if (next == nullptr) return std::nullopt;
  return next->Take();
}

void RecordingReader::Rewind() {
  for (const auto& lane : lanes_) lane->Begin(reader_, query_);
}

}  // namespace tendon::recording
