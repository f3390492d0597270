#include <tendon/gcm/text.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/recording_files.h>

#include <algorithm>
#include <system_error>

namespace tendon::recording {
namespace {

/// As ROS 2 prints it; Schema knows no time of day, which has the bytes of a duration.
constexpr const char* kLogText =
    "byte DEBUG=10\n"
    "byte INFO=20\n"
    "byte WARN=30\n"
    "byte ERROR=40\n"
    "byte FATAL=50\n"
    "builtin_interfaces/Time stamp\n"
    "uint8 level\n"
    "string name\n"
    "string msg\n"
    "string file\n"
    "string function\n"
    "uint32 line\n"
    "================================================================================\n"
    "MSG: builtin_interfaces/Time\n"
    "int32 sec\n"
    "uint32 nanosec\n";

template <typename T>
std::string MessageTextOf() {
  return RosMessage(SchemaOf<T>());
}
template <>
std::string MessageTextOf<RosLog>() {
  return kLogText;
}

std::int64_t NanosecondsOf(SteadyTime time) { return time.time_since_epoch().count(); }

/// "robot/arm/state/Joints"
std::string TopicOf(const Source& source, const Member& member) {
  return ToString(source.name) + "/" + member.name;
}

/// The units of all numbers of a member, by field: "tendon.unit.position": "rad".
void AddUnits(const Schema& schema, const std::string& prefix,
              std::map<std::string, std::string>& metadata) {
  for (const Schema::Field& field : schema.fields()) {
    const std::string path = prefix + "." + field.name;
    if (!field.unit.empty()) metadata["tendon.unit" + path] = field.unit;
    AddUnits(field.schema, path, metadata);
  }
}

bool HasSameMembers(const Source& a, const Source& b) {
  return std::ranges::equal(a.members, b.members, [](const Member& one, const Member& other) {
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

/// Channels of sources in one file, and so the most schemas: a file has at most 65,535 of each, and
/// the recorder has some of its own.
constexpr std::size_t kMostChannels = 65'000;

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

Files::Files(FileOptions options, Heading heading)
    : options_(std::move(options)),
      heading_(std::move(heading)),
      wall_minus_steady_(WallTime() - NanosecondsOf(SteadyClock().Now())),
      begin_(WallTime() - options_.past.count()) {}

Result<std::unique_ptr<Files>> Files::Create(FileOptions options, Heading heading) {
  std::unique_ptr<Files> files(new Files(std::move(options), std::move(heading)));
  if (auto begun = files->BeginFile(); !begun) return begun.error();
  return files;
}

Result<void> Files::Write(const Entry& entry) {
  if (auto begun = BeginNextFileIfDue(); !begun) return begun;
  return std::visit([this](const auto& one) { return Put(one); }, entry);
}

Result<void> Files::WriteLoss(const std::string& path, const LostRows& lost) {
  return WriteLoss(path, lost, SteadyClock().Now());
}

Result<void> Files::WriteLoss(const std::string& path, const LostRows& lost, SteadyTime time) {
  return Put(Loss{path, lost.table, lost.network, lost.viewer}, WallOf(time));
}

Result<void> Files::Sync() { return writer_->Sync(); }

Result<void> Files::Close(const Losses& losses) {
  mcap::Metadata by_path{kLossMetadata, {}};
  for (const auto& [path, lost] : losses.rows) {
    if (lost.all() > 0) by_path.metadata[path] = LossText(lost);
  }
  for (const auto& [path, lost] : losses.events) {
    if (lost > 0) by_path.metadata[path] = std::to_string(lost);
  }
  const LostRows all = losses.all_rows();
  const mcap::Metadata end{kEndMetadata,
                           {{"rows", std::to_string(counts_.rows)},
                            {"events", std::to_string(counts_.events)},
                            {"log_records", std::to_string(counts_.log)},
                            {"rows_lost_table", std::to_string(all.table)},
                            {"rows_lost_network", std::to_string(all.network)},
                            {"rows_lost_recorder", std::to_string(all.viewer)},
                            {"events_lost", std::to_string(losses.all_events())},
                            {"log_records_lost", std::to_string(losses.log)}}};
  // If one of these fails, Close() says why.
  if (!by_path.metadata.empty()) (void)writer_->Write(by_path);
  (void)writer_->Write(end);
  return writer_->Close();
}

Counts Files::counts() const {
  Counts counts = counts_;
  counts.bytes = writer_->written().bytes;
  for (std::size_t i = 0; i + 1 < files_.size(); ++i) counts.bytes += files_[i].second;
  counts.files = number_;
  return counts;
}

Result<void> Files::BeginNextFileIfDue() {
  const bool is_large = options_.split_size > 0 && writer_->written().bytes >= options_.split_size;
  const bool is_old =
      options_.split_time.count() > 0 && SteadyClock().Now() - file_begin_ >= options_.split_time;
  const std::size_t half_of_the_index = mcap::WriterOptions().largest_index / 2;
  const bool is_split = options_.split_size > 0 || options_.split_time.count() > 0;
  const bool is_full =
      is_split && (HasManyOldChannels() || writer_->index_size() > half_of_the_index);
  if (!is_large && !is_old && !is_full) return {};
  if (auto closed = writer_->Close(); !closed) return closed;
  files_.back().second = writer_->written().bytes;
  return BeginFile();
}

/// A component that is restarted again and again uses up the channels of a file. Another file helps
/// only against channels of earlier runs.
bool Files::HasManyOldChannels() const {
  if (channel_count_ <= kMostChannels / 2) return false;
  std::size_t used = 0;
  for (const auto* const known : {&tables_, &events_}) {
    for (const auto& [name, channels] : *known) used += channels.ids.size();
  }
  return used < channel_count_ / 2;
}

Result<void> Files::BeginFile() {
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

Result<std::unique_ptr<mcap::Writer>> Files::CreateWriter(const std::filesystem::path& name) const {
  const mcap::WriterOptions options{.profile = kProfile, .compression = options_.compression};
  if (!options_.create) return mcap::Writer::Create(name, options);
  auto file = options_.create(name);
  if (!file) return file.error();
  return mcap::Writer::Create(*std::move(file), options);
}

/// Leaves out numbers that an earlier recording has used, but never the first one.
std::filesystem::path Files::NextName() {
  ++number_;
  std::error_code ignored;
  const bool is_split = FileName(options_, 1) != options_.file;
  while (is_split && number_ > 1 && std::filesystem::exists(FileName(options_, number_), ignored)) {
    ++number_;
  }
  return FileName(options_, number_);
}

void Files::DropOldFiles() {
  while (options_.keep > 0 && files_.size() > options_.keep) {
    std::error_code ignored;
    std::filesystem::remove(files_.front().first, ignored);
    files_.pop_front();
  }
}

Result<mcap::SchemaId> Files::SchemaIdOf(const std::string& name, const std::string& text) {
  const auto known = schemas_.find({name, text});
  if (known != schemas_.end()) return known->second;
  const auto added = writer_->AddSchema(name, kSchemaEncoding, text);
  if (added) schemas_.emplace(std::pair(name, text), *added);
  return added;
}

Result<Files::Channels*> Files::ChannelsOf(std::map<InterfaceName, Channels>& known,
                                           const std::shared_ptr<const Source>& source,
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
    channels.refusal = added.error();  // so that nothing is added again for each entry
    return added.error();
  }
  return &channels;
}

Result<void> Files::AddChannels(Channels& channels, const Run& run) {
  const Source* source = channels.source.get();
  if (channel_count_ + source->members.size() > kMostChannels) {
    return Error{ErrorCode::kInvalid, files_.back().first.string() + " has no room for " +
                                          ToString(source->name) + ": it has " +
                                          std::to_string(channel_count_) + " channels of at most " +
                                          std::to_string(kMostChannels) +
                                          "; a recording with a split begins another file"};
  }
  for (const Member& member : source->members) {
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
    const auto id =
        writer_->AddChannel(*schema, TopicOf(*source, member), kMessageEncoding, metadata);
    if (!id) return id.error();
    channels.ids.push_back(*id);
    ++channel_count_;
  }
  return {};
}

Result<void> Files::Put(const Rows& rows) {
  const std::int64_t shift = wall_minus_steady_ - rows.clock_offset.count();
  const auto channels =
      ChannelsOf(tables_, rows.source, {"column", rows.epoch, shift, rows.clock_uncertainty});
  if (!channels) return channels.error();
  if (rows.lost_before.all() > 0 && !rows.times.empty()) {
    const Loss loss{ToString(rows.source->name), rows.lost_before.table, rows.lost_before.network,
                    rows.lost_before.viewer};
    const auto time = static_cast<mcap::Timestamp>(rows.times.front() + shift);
    if (auto written = Put(loss, time); !written) return written;
  }
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
  }
  return {};
}

Result<void> Files::Put(const Event& event) {
  const auto channels = ChannelsOf(
      events_, event.source, {"event", 0, wall_minus_steady_, std::chrono::nanoseconds::max()});
  if (!channels) return channels.error();
  constexpr std::byte kNone[] = {std::byte{0}};  // ROS 2's empty message has one byte
  const mcap::Bytes body = event.value.empty() ? mcap::Bytes(kNone) : mcap::Bytes(event.value);
  const mcap::Timestamp time = WallOf(event.raised);
  std::uint32_t& sequence = (*channels)->sequences.at(event.member);
  auto put = PutBody((*channels)->ids.at(event.member), sequence, time, time, body);
  if (!put) return put;
  ++sequence;
  ++counts_.events;
  return put;
}

/// Leaves out what was logged before the recording.
Result<void> Files::Put(const LogEntry& entry) {
  const message::LogRecord& record = entry.record;
  if (record.time < begin_) return {};
  const bool is_of_process = record.source == record.process || record.source.empty();
  const RosLog log{.stamp = std::chrono::nanoseconds(record.time),
                   .level = RosLevelOf(record.level),
                   .name = is_of_process ? record.process : record.process + "/" + record.source,
                   .msg = record.text,
                   .file = {},
                   .function = {}};
  auto put = PutOwn(log_, kLogTopic, log, static_cast<mcap::Timestamp>(record.time));
  if (put) ++counts_.log;
  return put;
}

Result<void> Files::Put(const Changes& changes) {
  if (changes.is_snapshot) {
    const std::uint64_t last = changes.changes.empty() ? 0 : changes.changes.back().revision;
    catalogue_ = Catalogue::At(last - changes.changes.size());
    changes_.sequence = 0;
  }
  for (const CatalogueChange& change : changes.changes) (void)catalogue_.Apply(change);
  return PutCatalogue(changes.changes, WallOf(changes.received));
}

Result<void> Files::PutCatalogue(const std::vector<CatalogueChange>& changes,
                                 mcap::Timestamp time) {
  for (const CatalogueChange& change : changes) {
    if (auto put = PutOwn(changes_, kCatalogueTopic, change, time); !put) return put;
  }
  return {};
}

Result<void> Files::Put(const Loss& loss, mcap::Timestamp time) {
  return PutOwn(losses_, kLossTopic, loss, time);
}

template <typename T>
Result<void> Files::PutOwn(OwnChannel& channel, const char* topic, const T& value,
                           mcap::Timestamp time) {
  if (!channel.id) {
    const Schema& schema = SchemaOf<T>();
    const auto schema_id = SchemaIdOf(RosTypeName(schema), MessageTextOf<T>());
    if (!schema_id) return schema_id.error();
    const auto id = writer_->AddChannel(*schema_id, topic, kMessageEncoding,
                                        {{kKindKey, "other"}, {kSchemaKey, schema.TextWithHelp()}});
    if (!id) return id.error();
    channel.id = *id;
  }
  body_.clear();
  Encode(value, body_);
  return PutBody(*channel.id, channel.sequence++, time, time, body_);
}

Result<void> Files::PutBody(mcap::ChannelId channel, std::uint32_t sequence,
                            mcap::Timestamp log_time, mcap::Timestamp publish_time,
                            mcap::Bytes body) {
  constexpr std::byte kLittleEndian{1};
  message_.assign(kEncapsulationSize, std::byte{0});
  message_[1] = kLittleEndian;
  message_.insert(message_.end(), body.begin(), body.end());
  return writer_->Write(mcap::Message{channel, sequence, log_time, publish_time, message_});
}

mcap::Timestamp Files::WallOf(SteadyTime time) const {
  return static_cast<mcap::Timestamp>(NanosecondsOf(time) + wall_minus_steady_);
}

}  // namespace tendon::recording
