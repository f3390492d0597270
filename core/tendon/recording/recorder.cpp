#include <tendon/recording/recorder.h>

#include <tendon/base/os/thread.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/recording/recording_selection.h>

#include <algorithm>
#include <iterator>
#include <system_error>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

/// Rows wait for up to 0.2 s on their way into the file, so at most 1 s of them is lost when the
/// program is killed.
constexpr auto kSyncPeriod = 800ms;

InterfaceName TableName(const TableSubscription& table) {
  return {table.process, table.component, table.table};
}

std::int64_t WallMinusSteady() {
  return WallTime() - SteadyClock().Now().time_since_epoch().count();
}

/// Finds mistakes now, before the condition becomes true.
Result<void> CheckFree(const FileOptions& options) {
  const std::filesystem::path file = FileName(options, 1);
  const std::filesystem::path folder = file.parent_path();
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) return mcap::FileExistsError(file);
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return {};
  return Error{ErrorCode::kFailed,
               "cannot write " + file.string() + ": " + folder.string() +
                   " is not a folder; create this folder, or choose another folder"};
}

/// The types of all arguments and results.
std::vector<Fingerprint> TypesIn(const Catalogue& catalogue, const EventSubscription& one) {
  std::vector<Fingerprint> types;
  const ProvidedDescription* provided = catalogue.FindProvided(one.provided);
  for (std::size_t i = 0; provided != nullptr && i < one.size(); ++i) {
    const MemberDescription* member =
        FindNamed(one.is_command(i) ? provided->commands : provided->events, one.name(i));
    if (member == nullptr) continue;
    if (TakesArgument(member->signature)) types.push_back(member->signature.in);
    if (WaitsForServer(member->signature.kind)) types.push_back(member->signature.out);
  }
  return types;
}

}  // namespace

Result<std::unique_ptr<Recorder>> Recorder::Start(GcmClient& client,
                                                  std::shared_ptr<RecordingQueue> queue,
                                                  RecorderOptions options) {
  auto system = std::make_shared<GcmSystem>(client, options.timeout);
  return Start(std::move(system), std::move(queue), std::move(options));
}

Result<std::unique_ptr<Recorder>> Recorder::Start(std::shared_ptr<RecordedSystem> system,
                                                  std::shared_ptr<RecordingQueue> queue,
                                                  RecorderOptions options) {
  Triggers triggers;
  const auto watch = [&](const std::optional<Condition>& condition,
                         std::unique_ptr<Trigger>& trigger) -> Result<void> {
    if (!condition) return {};
    auto made = Trigger::Make(*system, *condition, [weak = std::weak_ptr(queue)] {
      if (const auto alive = weak.lock()) alive->Wake();
    });
    if (!made) return made.error();
    trigger = *std::move(made);
    return {};
  };
  if (auto watched = watch(options.start_when, triggers.start); !watched) return watched.error();
  if (auto watched = watch(options.stop_when, triggers.stop); !watched) return watched.error();
  std::unique_ptr<RecordingWriter> writer;
  if (triggers.start) {
    if (auto is_free = CheckFree(options.files); !is_free) return is_free.error();
  } else {
    auto made =
        RecordingWriter::Create(options.files, HeadingFor(system->catalogue(), options.patterns));
    if (!made) return made.error();
    writer = *std::move(made);
  }
  if (options.has_log) system->WatchLog();
  return std::unique_ptr<Recorder>(new Recorder(std::move(system), std::move(queue),
                                                std::move(options), std::move(triggers),
                                                std::move(writer)));
}

Recorder::Recorder(std::shared_ptr<RecordedSystem> system, std::shared_ptr<RecordingQueue> queue,
                   RecorderOptions options, Triggers triggers,
                   std::unique_ptr<RecordingWriter> writer)
    : system_(std::move(system)),
      queue_(std::move(queue)),
      options_(std::move(options)),
      writer_(std::move(writer)),
      is_waiting_(writer_ == nullptr),
      next_sync_(SteadyClock().Now() + kSyncPeriod),
      triggers_(std::move(triggers)),
      past_(options_.before, options_.before_bytes, WallMinusSteady()),
      armed_(SteadyClock().Now()) {
  if (!triggers_.start) started_ = armed_;
  FollowOnce(false);  // so that the recording begins with present rows
  PublishStatus();
  following_thread_ = std::thread([this] {
    os::NameThisThread("rec follower");
    Follow();
  });
  writing_thread_ = std::thread([this] {
    os::NameThisThread("rec writer");
    WriteUntilStopped();
  });
}

Recorder::~Recorder() { (void)Stop(); }

Result<void> Recorder::Stop() {
  const std::scoped_lock one_at_a_time(stop_mutex_);
  if (stopped_) return *stopped_;
  {
    const std::scoped_lock lock(mutex_);
    follows_ = false;
    stop_.notify_all();
  }
  following_thread_.join();
  EndSubscriptions();
  {
    const std::scoped_lock lock(mutex_);
    is_drained_ = true;
  }
  queue_->Wake();
  writing_thread_.join();
  triggers_ = {};
  queue_->Close();
  Result<void> closed;
  if (writer_) {
    std::map<std::string, LostRows> rest = queue_->TakeTrailingLosses();
    for (const auto& [path, refused] : writer_->losses().rows) rest[path] += refused;
    for (const auto& [path, lost] : rest) {
      if (!status_.failure) (void)writer_->WriteLoss(path, lost);
    }
    closed = writer_->Close(LossesBeforeWriting());
  }
  PublishStatus();
  const std::scoped_lock lock(mutex_);
  // After a failure, Close() adds whether the file has an index.
  stopped_ = closed && status_.failure ? Result<void>(*status_.failure) : closed;
  return *stopped_;
}

RecorderStatus Recorder::status() const {
  std::unique_lock lock(mutex_);
  RecorderStatus status = status_;
  lock.unlock();
  status.losses = LossesOfRecording();
  status.waiting_bytes = queue_->waiting_bytes();
  std::error_code failed;
  const std::filesystem::path folder = status.file.parent_path();
  const auto disk = std::filesystem::space(folder.empty() ? "." : folder, failed);
  status.disk_free = failed ? 0 : disk.available;
  return status;
}

std::vector<std::string> Recorder::TakeNotices() {
  std::vector<std::string> all = queue_->TakeNotices();
  const std::scoped_lock lock(mutex_);
  all.insert(all.end(), notices_.begin(), notices_.end());
  notices_.clear();
  return all;
}

void Recorder::Follow() {
  constexpr auto kOften = 100ms;
  std::unique_lock lock(mutex_);
  while (follows_) {
    lock.unlock();
    FollowOnce(true);
    if (queue_->needs_snapshot()) system_->Resync();
    lock.lock();
    stop_.wait_for(lock, kOften, [this] { return !follows_; });
  }
}

/// If this function may not wait, it leaves out events whose types must be requested.
void Recorder::FollowOnce(bool may_wait) {
  // This must be read first, because the client has the new catalogue before the queue counts it.
  const std::uint64_t snapshots = queue_->snapshots();
  if (has_all_events_ && system_->revision() == revision_ && snapshots == snapshots_) return;
  const Catalogue catalogue = system_->catalogue();
  const bool is_next = snapshots == snapshots_ && catalogue.revision() >= revision_;
  if (!is_next) gone_.clear();
  revision_ = catalogue.revision();
  snapshots_ = snapshots;
  RecordingSelection wanted = Select(catalogue, options_.patterns);
  FollowTables(wanted.tables, catalogue);
  silent_.clear();
  std::vector<EventSubscription>& all = wanted.events;
  std::ranges::move(wanted.commands, std::back_inserter(all));
  has_all_events_ = FollowEvents(all, catalogue, may_wait);
  NoteGoneProcesses(catalogue);
  std::set<InterfaceName> interfaces;
  for (const EventSubscription& one : all) interfaces.insert(one.provided);
  for (const auto& [key, listener] : listeners_) interfaces.insert(key.interface);
  const std::scoped_lock lock(mutex_);
  status_.tables = tables_.size();
  status_.interfaces = interfaces.size();
}

void Recorder::NoteGoneProcesses(const Catalogue& catalogue) {
  gone_.clear();
  for (const auto& [name, entry] : catalogue.processes()) {
    const ProcessState state = entry.process.state;
    if (state == ProcessState::kLost || state == ProcessState::kLeft) gone_.insert(name);
  }
}

/// Returns true if a process has ended. A new GCM does not know a process before the process has
/// joined. Therefore, a process that is only missing in the catalogue keeps its subscriptions.
/// These subscriptions recover by themselves and count their losses.
bool Recorder::IsEnded(const Catalogue& catalogue, const std::string& process) const {
  const ProcessEntry* entry = catalogue.FindProcess(process);
  if (entry != nullptr) return entry->process.state == ProcessState::kAlive;
  return gone_.contains(process);  // only a process that is gone can be forgotten
}

void Recorder::FollowTables(const std::vector<TableSubscription>& wanted,
                            const Catalogue& catalogue) {
  std::map<InterfaceName, Table> now;
  for (const TableSubscription& one : wanted) {
    auto known = tables_.extract(TableName(one));
    if (!known.empty() && known.mapped().subscription.columns == one.columns) {
      now.insert(std::move(known));
      continue;
    }
    if (!known.empty()) system_->telemetry().Unsubscribe(known.mapped().id);
    now[TableName(one)] = {one, system_->telemetry().Subscribe(one, queue_->SinkOf(one))};
  }
  for (auto& [name, rest] : tables_) {
    if (IsEnded(catalogue, name.process)) {
      system_->telemetry().Unsubscribe(rest.id);
    } else {
      now[name] = std::move(rest);
    }
  }
  tables_ = std::move(now);
}

bool Recorder::FollowEvents(const std::vector<EventSubscription>& wanted,
                            const Catalogue& catalogue, bool may_wait) {
  std::map<ListenerKey, Listener> now;
  bool has_all = true;
  for (const EventSubscription& one : wanted) {
    const ListenerKey key{one.provided, !one.commands.empty()};
    const std::vector<Fingerprint> types = TypesIn(catalogue, one);
    auto known = listeners_.extract(key);
    if (!known.empty() && known.mapped().subscription == one && known.mapped().types == types) {
      now.insert(std::move(known));
      continue;
    }
    if (!may_wait && !std::ranges::all_of(
                         types, [&](const Fingerprint& type) { return types_.contains(type); })) {
      if (!known.empty()) now.insert(std::move(known));
      has_all = false;
      continue;
    }
    if (!known.empty()) system_->StopListening(known.mapped().id);
    auto found = TypesOf(catalogue, one, types);
    const bool is_complete =
        std::ranges::all_of(types, [&](const Fingerprint& type) { return found.contains(type); });
    const auto id = system_->Listen(one, queue_->SinkOf(one, std::move(found)));
    // An incomplete list is requested again after the next change of the catalogue.
    now[key] = {one, is_complete ? types : std::vector<Fingerprint>(), id};
  }
  for (auto& [key, rest] : listeners_) {
    if (IsEnded(catalogue, key.interface.process)) {
      system_->StopListening(rest.id);
    } else {
      now[key] = std::move(rest);
    }
  }
  listeners_ = std::move(now);
  return has_all;
}

/// Requests unknown types from the process, unless the process is gone, because then it raises no
/// events. A process that does not answer in time is asked only once for each change of the
/// catalogue.
std::map<Fingerprint, Schema> Recorder::TypesOf(const Catalogue& catalogue,
                                                const EventSubscription& events,
                                                const std::vector<Fingerprint>& types) {
  const ProcessEntry* entry = catalogue.FindProcess(events.provided.process);
  const bool is_alive = entry != nullptr && entry->process.state == ProcessState::kAlive;
  std::map<Fingerprint, Schema> found;
  for (const Fingerprint type : types) {
    const auto known = types_.find(type);
    if (known != types_.end()) {
      found.insert(*known);
      continue;
    }
    if (!is_alive || silent_.contains(events.provided.process) || IsStopping()) continue;
    const auto schema = system_->FindSchema(events.provided.process, type);
    if (schema) {
      types_.emplace(type, *schema);
      found.emplace(type, *schema);
      continue;
    }
    if (schema.error().code == ErrorCode::kTimeout) silent_.insert(events.provided.process);
    const std::scoped_lock lock(mutex_);
    notices_.push_back((events.commands.empty() ? "events of " : "commands of ") +
                       ToString(events.provided) +
                       " cannot be recorded: " + schema.error().message);
  }
  return found;
}

bool Recorder::IsStopping() const {
  const std::scoped_lock lock(mutex_);
  return !follows_;
}

void Recorder::EndSubscriptions() {
  for (const auto& [name, table] : tables_) system_->telemetry().Unsubscribe(table.id);
  for (const auto& [name, listener] : listeners_) system_->StopListening(listener.id);
}

/// The writing thread. After a failure, it counts arriving entries as lost.
void Recorder::WriteUntilStopped() {
  while (true) {
    bool is_last = false;
    {
      const std::scoped_lock lock(mutex_);
      is_last = is_drained_;
    }
    const auto written = WriteSome();
    PublishStatus();
    if (!written) {
      const std::scoped_lock lock(mutex_);
      if (!status_.failure) status_.failure = written.error();
    }
    if (is_last && queue_->waiting_bytes() == 0) return;
  }
}

Result<void> Recorder::WriteSome() {
  constexpr auto kMaxWait = 100ms;
  Result<void> result;
  for (RecordingEntry& entry : queue_->Take(kMaxWait)) {
    if (is_waiting_) {
      past_.Add(std::move(entry), SteadyClock().Now());
    } else if (auto written = Write(std::move(entry)); !written) {
      result = written;
    }
  }
  if (!result) return result;
  if (is_waiting_) return StartIfDue();
  const SteadyTime now = SteadyClock().Now();
  StopIfDue(now);
  if (!writer_ || now < next_sync_) return {};
  next_sync_ = now + kSyncPeriod;
  return writer_->Sync();
}

Result<void> Recorder::Write(RecordingEntry entry) {
  // The event or call that ends the recording is a part of it. The trigger has its own
  // subscription, so it may have stored a slightly earlier time for this event or call.
  constexpr auto kSameEvent = 200ms;
  const bool is_event = std::holds_alternative<EventEntry>(entry);
  const SteadyTime to = is_event && to_ != SteadyTime::max() ? to_ + kSameEvent : to_;
  const LostRows lost = LostBefore(entry);
  const bool is_wanted = Trim(entry, from_, to, WallMinusSteady());
  if (LostBefore(entry) != lost || (!is_wanted && lost.all() > 0)) {
    const std::scoped_lock lock(mutex_);
    losses_before_.rows[ToString(std::get<RowsEntry>(entry).source->name)] += lost;
  }
  return is_wanted ? WriteOrNotice(entry) : Result<void>();
}

/// Continues if the file cannot hold an entry, such as rows with a type that is too large.
Result<void> Recorder::WriteOrNotice(const RecordingEntry& entry) {
  if (!writer_) {
    const std::scoped_lock lock(mutex_);
    unwritten_.AddUnwritten(entry);
    return {};
  }
  auto written = writer_->Write(entry);
  if (written || written.error().code != ErrorCode::kInvalid) return written;
  std::string path = PathOf(entry);
  if (path.empty()) path = std::holds_alternative<LogEntry>(entry) ? "the log" : "the catalogue";
  const std::scoped_lock lock(mutex_);
  if (refused_paths_.insert(path).second) {
    notices_.push_back(path + " is not recorded completely: " + written.error().message);
  }
  return {};
}

Result<void> Recorder::StartIfDue() {
  KeepLosses();
  const auto start = triggers_.start ? triggers_.start->FirstAfter(armed_) : std::nullopt;
  return start ? Begin(*start) : Result<void>();
}

Result<void> Recorder::Begin(SteadyTime start) {
  is_waiting_ = false;
  started_ = start;
  from_ = start - options_.before;
  Losses missing = past_.MissingSince(from_);
  std::map<std::string, LostRows> lost_rows = past_.LostBeforeMissingSince(from_);
  for (const auto& [path, lost] : missing.rows) lost_rows[path] += lost;
  const std::deque<RecordingEntry> entries = past_.TakeSince(from_);
  {
    const std::scoped_lock lock(mutex_);
    losses_before_ = LossesUntil(from_);
    losses_before_.rows = past_.losses();
    status_.before_rows_missing = missing.all_rows().viewer;
    status_.before_others_missing = missing.all_events() + missing.log;
    missing_before_ = std::move(missing);
  }
  FileOptions options = options_.files;
  options.past = SteadyClock().Now() - from_;
  auto writer =
      RecordingWriter::Create(options, HeadingFor(system_->catalogue(), options_.patterns));
  Result<void> result = writer ? Result<void>() : Result<void>(writer.error());
  if (writer) writer_ = *std::move(writer);
  for (const auto& [path, lost] : lost_rows) {
    if (result) result = writer_->WriteLoss(path, lost, from_);
  }
  for (const RecordingEntry& entry : entries) {
    if (auto written = WriteOrNotice(entry); !written) result = written;
  }
  return result;
}

/// While the recorder waits, keeps the losses of events and of the log, so that losses before the
/// recording can be subtracted later. At most about 100 of them are kept.
void Recorder::KeepLosses() {
  constexpr auto kShortest = 100ms;
  constexpr int kMax = 100;
  const SteadyTime now = SteadyClock().Now();
  const auto pause = std::max<std::chrono::nanoseconds>(kShortest, options_.before / kMax);
  if (!kept_losses_.empty() && now - kept_losses_.back().first < pause) return;
  kept_losses_.emplace_back(now, queue_->losses());
  // The longest delay until the recorder knows that a trigger has fired.
  constexpr auto kLatest = 1s;
  while (kept_losses_.size() > 1 && kept_losses_[1].first <= now - options_.before - kLatest) {
    kept_losses_.pop_front();
  }
}

/// The losses of events and of the log up to `time`, or somewhat earlier.
Losses Recorder::LossesUntil(SteadyTime time) const {
  Losses losses;
  for (const auto& [kept, up_to_then] : kept_losses_) {
    if (kept <= time) losses = up_to_then;
  }
  return losses;
}

void Recorder::StopIfDue(SteadyTime now) {
  constexpr auto kLatest = 300ms;  // until the last rows have arrived
  if (triggers_.stop && to_ == SteadyTime::max()) {
    if (const auto stop = triggers_.stop->FirstAfter(started_)) to_ = *stop + options_.after;
  }
  if (to_ == SteadyTime::max() || now < to_ + kLatest) return;
  const std::scoped_lock lock(mutex_);
  status_.is_finished = true;
}

/// Without those of the writer.
Losses Recorder::LossesBeforeWriting() const {
  // The queue is read under the lock, because it has already counted the losses that are subtracted
  // here.
  const std::scoped_lock lock(mutex_);
  Losses losses = queue_->losses();
  for (const auto& [path, before] : losses_before_.rows) {
    LostRows& lost = losses.rows[path];
    lost.table -= before.table;
    lost.network -= before.network;
    lost.viewer -= before.viewer;
  }
  for (const auto& [path, before] : losses_before_.events) losses.events[path] -= before;
  losses.log -= losses_before_.log;
  losses += missing_before_;
  return losses;
}

Losses Recorder::LossesOfRecording() const {
  Losses losses = LossesBeforeWriting();
  const std::scoped_lock lock(mutex_);
  losses += unwritten_;
  return losses;
}

void Recorder::PublishStatus() {
  const std::scoped_lock lock(mutex_);
  status_.is_waiting = is_waiting_;
  status_.before_bytes = past_.bytes();
  if (writer_) {
    status_.counts = writer_->counts();
    unwritten_ = writer_->losses();
  }
  status_.file = writer_ ? writer_->file() : options_.files.file;
}

}  // namespace tendon::recording
