#include <tendon/recording/recording_writer.h>

#include <tendon/gcm/text.h>
#include <tendon/interface/observed_call.h>
#include <tendon/payload/codec.h>

#include <algorithm>
#include <system_error>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

template <typename T>
std::string MessageTextOf() {
  return RosMessage(SchemaOf<T>());
}
template <>
std::string MessageTextOf<RosLog>() {
  return RosLogDefinition();
}

std::int64_t NanosecondsOf(SteadyTime time) { return time.time_since_epoch().count(); }

/// The units of all numbers of a member, by field: "tendon.unit.position": "rad".
void AddUnits(const Schema& schema, const std::string& prefix,
              std::map<std::string, std::string>& metadata) {
  for (const Schema::Field& field : schema.fields()) {
    const std::string path = prefix + "." + field.name;
    if (!field.unit.empty()) metadata[kUnitKey + path] = field.unit;
    AddUnits(field.schema, path, metadata);
  }
}

bool HasSameMembers(const EntrySource& a, const EntrySource& b) {
  return std::ranges::equal(a.members, b.members,
                            [](const EntryMember& one, const EntryMember& other) {
                              return one.name == other.name && one.schema == other.schema;
                            });
}

std::uint8_t RosLevelOf(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return 10;
    case LogLevel::kInfo:
      return 20;
    case LogLevel::kWarning:
      return 30;
    case LogLevel::kError:
      return 40;
  }
  return 40;
}

/// The maximum number of channels of sources in one file, and therefore of schemas. A file can have
/// 65,535 of each, and the recorder itself uses some.
constexpr std::size_t kMaxChannels = 65'000;

std::string LossText(const LostRows& lost) {
  return std::to_string(lost.table) + " in the table, " + std::to_string(lost.network) +
         " on the network, " + std::to_string(lost.viewer) + " in the recorder";
}

}  // namespace

std::filesystem::path FileName(const FileOptions& options, std::size_t number) {
  if (options.split_size == 0 && options.split_time.count() == 0) return options.file;
  return options.file.parent_path() / (options.file.stem().string() + "-" + std::to_string(number) +
                                       options.file.extension().string());
}

RecordingWriter::RecordingWriter(FileOptions options, Heading heading)
    : options_(std::move(options)),
      heading_(std::move(heading)),
      wall_minus_steady_(WallTime() - NanosecondsOf(SteadyClock().Now())),
      begin_(WallTime() - options_.past.count()) {}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::Create(FileOptions options,
                                                                 Heading heading) {
  std::unique_ptr<RecordingWriter> files(
      new RecordingWriter(std::move(options), std::move(heading)));
  if (auto begun = files->BeginFile(); !begun) return begun.error();
  return files;
}

Result<void> RecordingWriter::Write(const RecordingEntry& entry) {
  const std::uint64_t before = counts_.rows;
  auto written = failure_ ? Result<void>(*failure_) : TryWrite(entry);
  if (written) return written;
  refused_.AddUnwritten(entry, counts_.rows - before);
  if (!failure_ && written.error().code != ErrorCode::kInvalid) failure_ = written.error();
  return written;
}

Result<void> RecordingWriter::TryWrite(const RecordingEntry& entry) {
  if (auto begun = BeginNextFileIfDue(); !begun) return begun;
  ForgetWritten();
  return std::visit([this](const auto& one) { return Put(one); }, entry);
}

void RecordingWriter::ForgetWritten() {
  const std::uint64_t written = writer_->written().messages;
  const auto is_written = [&](const AcceptedEntry& one) {
    return one.first + one.count * one.width <= written;
  };
  while (!accepted_.empty() && is_written(accepted_.front())) accepted_.pop_front();
}

/// The number of messages of `one` in a chunk that could not be written.
std::uint64_t RecordingWriter::UnwrittenOf(const AcceptedEntry& one) const {
  if (!writer_->failure()) return 0;
  const std::uint64_t written = writer_->written().messages;
  const std::uint64_t safe = written > one.first ? (written - one.first) / one.width : 0;
  return one.count - std::min(one.count, safe);
}

Losses RecordingWriter::UnwrittenChunk() const {
  Losses losses;
  for (const AcceptedEntry& one : accepted_) {
    const std::uint64_t lost = UnwrittenOf(one);
    if (lost == 0) continue;
    if (one.source == nullptr) {
      losses.log += lost;
    } else if (one.event) {
      losses.events[ToString(one.source->name) + "." + one.source->members.at(*one.event).name] +=
          lost;
    } else {
      losses.rows[ToString(one.source->name)].viewer += lost;
    }
  }
  return losses;
}

Losses RecordingWriter::losses() const {
  Losses losses = UnwrittenChunk();
  losses += refused_;
  return losses;
}

Result<void> RecordingWriter::WriteLoss(const std::string& path, const LostRows& lost) {
  return WriteLoss(path, lost, SteadyClock().Now());
}

Result<void> RecordingWriter::WriteLoss(const std::string& path, const LostRows& lost,
                                        SteadyTime time) {
  return Put(Loss{path, lost.table, lost.network, lost.viewer}, WallOf(time));
}

Result<void> RecordingWriter::Sync() { return writer_->Sync(); }

Result<void> RecordingWriter::Close(const Losses& others) {
  (void)writer_->Flush();  // so that the losses are known; Close() returns the error
  Losses losses = this->losses();
  losses += others;
  const Counts in_file = counts();
  mcap::Metadata by_path{kLossMetadata, {}};
  for (const auto& [path, lost] : losses.rows) {
    if (lost.all() > 0) by_path.metadata[path] = LossText(lost);
  }
  for (const auto& [path, lost] : losses.events) {
    if (lost > 0) by_path.metadata[path] = std::to_string(lost);
  }
  const LostRows all = losses.all_rows();
  const mcap::Metadata end{kEndMetadata,
                           {{"rows", std::to_string(in_file.rows)},
                            {"events", std::to_string(in_file.events)},
                            {"commands", std::to_string(in_file.commands)},
                            {"log_records", std::to_string(in_file.log)},
                            {"rows_lost_table", std::to_string(all.table)},
                            {"rows_lost_network", std::to_string(all.network)},
                            {"rows_lost_recorder", std::to_string(all.viewer)},
                            {"events_lost", std::to_string(losses.all_events())},
                            {"log_records_lost", std::to_string(losses.log)}}};
  std::vector<mcap::Metadata> last{end};
  if (!by_path.metadata.empty()) last.push_back(std::move(by_path));
  if (auto closed = writer_->Close(last); !closed) return closed;
  return failure_ ? Result<void>(*failure_) : Result<void>();
}

Counts RecordingWriter::counts() const {
  Counts counts = counts_;
  for (const AcceptedEntry& one : accepted_) {
    const std::uint64_t lost = UnwrittenOf(one);
    if (one.source == nullptr) {
      counts.log -= lost;
    } else if (!one.event) {
      counts.rows -= lost;
    } else {
      (one.source->are_commands ? counts.commands : counts.events) -= lost;
    }
  }
  counts.bytes = writer_->written().bytes;
  for (std::size_t i = 0; i + 1 < files_.size(); ++i) counts.bytes += files_[i].second;
  counts.files = number_;
  return counts;
}

Result<void> RecordingWriter::BeginNextFileIfDue() {
  const bool is_large = options_.split_size > 0 && writer_->written().bytes >= options_.split_size;
  const bool is_old =
      options_.split_time.count() > 0 && SteadyClock().Now() - file_begin_ >= options_.split_time;
  const std::size_t half_of_the_index = mcap::WriterOptions().largest_index / 2;
  const bool is_split = options_.split_size > 0 || options_.split_time.count() > 0;
  const bool is_full =
      is_split && (HasManyOldChannels() || writer_->index_size() > half_of_the_index);
  if (!is_large && !is_old && !is_full) return {};
  if (auto flushed = writer_->Flush(); !flushed) return flushed;
  if (auto closed = writer_->Close(); !closed) return closed;
  accepted_.clear();
  files_.back().second = writer_->written().bytes;
  return BeginFile();
}

/// A component that is restarted again and again uses up the channels of a file. A new file helps
/// only if most channels belong to earlier runs.
bool RecordingWriter::HasManyOldChannels() const {
  if (channel_count_ <= kMaxChannels / 2) return false;
  std::size_t used = 0;
  for (const auto* const known : {&tables_, &events_, &commands_}) {
    for (const auto& [name, channels] : *known) used += channels.ids.size();
  }
  return used < channel_count_ / 2;
}

Result<void> RecordingWriter::BeginFile() {
  const std::filesystem::path name = NextName();
  auto writer = CreateWriter(name);
  if (!writer) return writer.error();
  writer_ = *std::move(writer);
  files_.emplace_back(name, 0);
  DropOldFiles();
  file_begin_ = SteadyClock().Now();
  schemas_.clear();
  channel_count_ = 0;
  tables_.clear();
  events_.clear();
  commands_.clear();
  log_ = losses_ = changes_ = {};

  const mcap::Timestamp now = WallOf(file_begin_);
  mcap::Metadata about{kAboutMetadata, heading_.about};
  about.metadata["version"] = "1";
  about.metadata["file"] = std::to_string(number_);
  about.metadata["begin_ns"] = std::to_string(now);
  about.metadata["wall_minus_steady_ns"] = std::to_string(wall_minus_steady_);
  if (auto written = writer_->Write(about); !written) return written;
  if (!heading_.system.empty()) {
    const auto text = std::as_bytes(std::span(heading_.system));
    const mcap::Attachment system{
        now, now, kSystemAttachment, "application/json", {text.begin(), text.end()}};
    if (auto written = writer_->Write(system); !written) return written;
  }
  if (number_ == 1) return {};
  return PutCatalogue(catalogue_.AsChanges(), now);
}

Result<std::unique_ptr<mcap::Writer>> RecordingWriter::CreateWriter(
    const std::filesystem::path& name) const {
  const mcap::WriterOptions options{.profile = kProfile, .compression = options_.compression};
  if (!options_.create) return mcap::Writer::Create(name, options);
  auto file = options_.create(name);
  if (!file) return file.error();
  return mcap::Writer::Create(*std::move(file), options);
}

/// Skips numbers that an earlier recording has used, but never the first number.
std::filesystem::path RecordingWriter::NextName() {
  ++number_;
  std::error_code ignored;
  const bool is_split = FileName(options_, 1) != options_.file;
  while (is_split && number_ > 1 && std::filesystem::exists(FileName(options_, number_), ignored)) {
    ++number_;
  }
  return FileName(options_, number_);
}

void RecordingWriter::DropOldFiles() {
  while (options_.keep > 0 && files_.size() > options_.keep) {
    std::error_code ignored;
    std::filesystem::remove(files_.front().first, ignored);
    files_.pop_front();
  }
}

Result<mcap::SchemaId> RecordingWriter::SchemaIdOf(const std::string& name,
                                                   const std::string& text) {
  const auto known = schemas_.find({name, text});
  if (known != schemas_.end()) return known->second;
  const auto added = writer_->AddSchema(name, kSchemaEncoding, text);
  if (added) schemas_.emplace(std::pair(name, text), *added);
  return added;
}

Result<RecordingWriter::Channels*> RecordingWriter::ChannelsOf(
    std::map<InterfaceName, Channels>& known, const std::shared_ptr<const EntrySource>& source,
    const Run& run) {
  Channels& channels = known[source->name];
  const bool fits = channels.source != nullptr && channels.epoch == run.epoch &&
                    (channels.source == source || HasSameMembers(*channels.source, *source));
  if (fits) {
    channels.source = source;
    if (channels.refusal) return *channels.refusal;
    return &channels;
  }
  channels = {.source = source,
              .epoch = run.epoch,
              .ids = {},
              .sequences = {},
              .clock = run.clock,
              .refusal = {}};
  channels.sequences.resize(source->members.size());
  if (auto added = AddChannels(channels, run); !added) {
    channels.refusal = added.error();  // so that no channel is added again for each entry
    return added.error();
  }
  return &channels;
}

Result<void> RecordingWriter::AddChannels(Channels& channels, const Run& run) {
  const EntrySource* source = channels.source.get();
  if (channel_count_ + source->members.size() > kMaxChannels) {
    return Error{ErrorCode::kInvalid, files_.back().first.string() + " has no room for " +
                                          ToString(source->name) + ": it has " +
                                          std::to_string(channel_count_) + " channels of at most " +
                                          std::to_string(kMaxChannels) +
                                          "; a recording with a split begins another file"};
  }
  for (const EntryMember& member : source->members) {
    const auto schema = SchemaIdOf(RosTypeName(member.schema), RosMessage(member.schema));
    if (!schema) return schema.error();
    std::map<std::string, std::string> metadata = {
        {kKindKey, run.kind},
        {kPathKey, ToString(source->name) + "." + member.name},
        {kSchemaKey, member.schema.TextWithHelp()},
        {kEpochKey, std::to_string(run.epoch)},
        {kClockKey, std::to_string(run.clock)}};
    if (run.uncertainty != std::chrono::nanoseconds::max()) {
      metadata[kClockUncertaintyKey] = std::to_string(run.uncertainty.count());
    }
    AddUnits(member.schema, "", metadata);
    const auto id = writer_->AddChannel(*schema, TopicOf(source->name, member.name),
                                        kMessageEncoding, metadata);
    if (!id) return id.error();
    channels.ids.push_back(*id);
    ++channel_count_;
  }
  return {};
}

Result<void> RecordingWriter::Put(const RowsEntry& rows) {
  const std::int64_t shift = wall_minus_steady_ - rows.clock_offset.count();
  const auto channels =
      ChannelsOf(tables_, rows.source, {kColumnKind, rows.epoch, shift, rows.clock_uncertainty});
  if (!channels) return channels.error();
  if (rows.lost_before.all() > 0 && !rows.times.empty()) {
    const Loss loss{ToString(rows.source->name), rows.lost_before.table, rows.lost_before.network,
                    rows.lost_before.viewer};
    const auto time = static_cast<mcap::Timestamp>(rows.times.front() + shift);
    if (auto written = Put(loss, time); !written) return written;
  }
  accepted_.push_back({.source = rows.source,
                       .event = {},
                       .first = writer_->accepted().messages,
                       .width = std::max<std::uint64_t>(1, (*channels)->ids.size()),
                       .count = 0});
  const std::span<const std::byte> cells(rows.cells);
  std::size_t offset = 0;
  std::size_t cell = 0;
  for (std::size_t row = 0; row < rows.ticks.size(); ++row) {
    const auto log_time = static_cast<mcap::Timestamp>(rows.times[row] + shift);
    const auto publish_time = static_cast<mcap::Timestamp>(rows.times[row] + (*channels)->clock);
    const auto tick = static_cast<std::uint32_t>(rows.ticks[row]);
    for (const mcap::ChannelId id : (*channels)->ids) {
      const std::size_t size = rows.cell_sizes[cell++];
      const auto body = cells.subspan(offset, size);
      if (auto put = PutBody(id, tick, log_time, publish_time, body); !put) return put;
      offset += size;
    }
    ++counts_.rows;
    ++accepted_.back().count;
  }
  return {};
}

Result<void> RecordingWriter::Put(const EventEntry& event) {
  const bool is_call = event.source->are_commands;
  const auto channels = ChannelsOf(is_call ? commands_ : events_, event.source,
                                   {is_call ? kCommandKind : kEventKind, 0, wall_minus_steady_,
                                    std::chrono::nanoseconds::max()});
  if (!channels) return channels.error();
  constexpr std::byte kNone[] = {std::byte{0}};  // ROS 2's empty message has one byte
  const mcap::ByteView body =
      event.value.empty() ? mcap::ByteView(kNone) : mcap::ByteView(event.value);
  const std::chrono::nanoseconds took = is_call ? HeaderOfCall(body).took : 0ns;
  const mcap::Timestamp time = WallOf(event.raised - took);
  std::uint32_t& sequence = (*channels)->sequences.at(event.member);
  const std::uint64_t first = writer_->accepted().messages;
  auto put = PutBody((*channels)->ids.at(event.member), sequence, time, time, body);
  if (!put) return put;
  ++sequence;
  ++(is_call ? counts_.commands : counts_.events);
  accepted_.push_back(
      {.source = event.source, .event = event.member, .first = first, .width = 1, .count = 1});
  return put;
}

/// Leaves out records that were logged before the recording.
Result<void> RecordingWriter::Put(const LogEntry& entry) {
  const message::LogRecord& record = entry.record;
  if (record.time < begin_) return {};
  const bool is_of_process = record.source == record.process || record.source.empty();
  const RosLog log{.stamp = std::chrono::nanoseconds(record.time),
                   .level = RosLevelOf(record.level),
                   .name = is_of_process ? record.process : record.process + "/" + record.source,
                   .msg = record.text,
                   .file = {},
                   .function = {}};
  const std::uint64_t first = writer_->accepted().messages;
  auto put = PutOwn(log_, kLogTopic, log, static_cast<mcap::Timestamp>(record.time));
  if (!put) return put;
  ++counts_.log;
  accepted_.push_back({.source = {}, .event = {}, .first = first, .width = 1, .count = 1});
  return put;
}

Result<void> RecordingWriter::Put(const CatalogueEntry& changes) {
  if (changes.is_snapshot) {
    const std::uint64_t last = changes.changes.empty() ? 0 : changes.changes.back().revision;
    catalogue_ = Catalogue::At(last - changes.changes.size());
    changes_.sequence = 0;
  }
  for (const CatalogueChange& change : changes.changes) (void)catalogue_.Apply(change);
  return PutCatalogue(changes.changes, WallOf(changes.received));
}

Result<void> RecordingWriter::PutCatalogue(const std::vector<CatalogueChange>& changes,
                                           mcap::Timestamp time) {
  for (const CatalogueChange& change : changes) {
    if (auto put = PutOwn(changes_, kCatalogueTopic, change, time); !put) return put;
  }
  return {};
}

Result<void> RecordingWriter::Put(const Loss& loss, mcap::Timestamp time) {
  return PutOwn(losses_, kLossTopic, loss, time);
}

template <typename T>
Result<void> RecordingWriter::PutOwn(OwnChannel& channel, const char* topic, const T& value,
                                     mcap::Timestamp time) {
  if (!channel.id) {
    const Schema& schema = SchemaOf<T>();
    const auto schema_id = SchemaIdOf(RosTypeName(schema), MessageTextOf<T>());
    if (!schema_id) return schema_id.error();
    const auto id =
        writer_->AddChannel(*schema_id, topic, kMessageEncoding,
                            {{kKindKey, kOtherKind}, {kSchemaKey, schema.TextWithHelp()}});
    if (!id) return id.error();
    channel.id = *id;
  }
  body_.clear();
  Encode(value, body_);
  return PutBody(*channel.id, channel.sequence++, time, time, body_);
}

Result<void> RecordingWriter::PutBody(mcap::ChannelId channel, std::uint32_t sequence,
                                      mcap::Timestamp log_time, mcap::Timestamp publish_time,
                                      mcap::ByteView body) {
  Encapsulate(body, message_);
  return writer_->Write(mcap::Message{channel, sequence, log_time, publish_time, message_});
}

mcap::Timestamp RecordingWriter::WallOf(SteadyTime time) const {
  return static_cast<mcap::Timestamp>(NanosecondsOf(time) + wall_minus_steady_);
}

}  // namespace tendon::recording
