#include <tendon/base/os/process.h>
#include <tendon/base/os/thread.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/text.h>
#include <tendon/recording/recorder.h>

#include <algorithm>
#include <system_error>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

/// Rows wait for up to 0.2 s on their way into the file, so at most 1 s of them is lost when the
/// program is killed.
constexpr auto kSyncPeriod = 800ms;

bool IsWithinAny(const std::vector<std::string>& patterns, const std::string& path) {
  return std::ranges::any_of(
      patterns, [&](const std::string& pattern) { return IsWithinGlob(pattern, path); });
}

InterfaceName TableName(const TableSubscription& table) {
  return {table.process, table.component, table.table};
}

std::int64_t WallMinusSteady() {
  return WallTime() - SteadyClock().Now().time_since_epoch().count();
}

/// Finds mistakes now, and not when the condition is true.
Result<void> CheckFree(const FileOptions& options) {
  const std::filesystem::path file = FileName(options, 1);
  const std::filesystem::path folder = file.parent_path();
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    return Error{ErrorCode::kExists, file.string() + " already exists; choose another name"};
  }
  if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return {};
  return Error{ErrorCode::kFailed,
               "cannot write " + file.string() + ": " + folder.string() +
                   " is not a folder; create this folder, or choose another folder"};
}

}  // namespace

Choice Choose(const Catalogue& catalogue, const std::vector<std::string>& patterns) {
  Choice choice;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [component, description] : entry.components) {
      for (const TableDescription& table : description.tables) {
        TableSubscription one{process, component, table.name, {}};
        const std::string path = ToString(TableName(one)) + ".";
        for (const auto& column : table.columns) {
          if (IsWithinAny(patterns, path + column.name)) one.columns.push_back(column.name);
        }
        if (!one.columns.empty()) choice.tables.push_back(std::move(one));
      }
      for (const ProvidedDescription& provided : description.provided) {
        EventSubscription one{.provided = {process, component, provided.name}, .events = {}};
        const std::string path = ToString(one.provided) + ".";
        for (const MemberDescription& event : provided.events) {
          if (IsWithinAny(patterns, path + event.name)) one.events.push_back(event.name);
        }
        if (!one.events.empty()) choice.events.push_back(std::move(one));
      }
    }
  }
  return choice;
}

Heading HeadingFor(const Catalogue& catalogue, const std::vector<std::string>& patterns) {
  Heading heading{{{"paths", Joined(patterns, " ")}, {"recorded_by", os::UserAtHost()}}, ""};
  auto text = SystemFileText(SystemOf(catalogue, "recorded").file);
  if (text) heading.system = *std::move(text);
  return heading;
}

Result<std::unique_ptr<Recorder>> Recorder::Start(GcmClient& client, std::shared_ptr<Inbox> inbox,
                                                  RecorderOptions options) {
  auto system = std::make_shared<GcmAccess>(client, options.timeout);
  return Start(std::move(system), std::move(inbox), std::move(options));
}

Result<std::unique_ptr<Recorder>> Recorder::Start(std::shared_ptr<SystemAccess> system,
                                                  std::shared_ptr<Inbox> inbox,
                                                  RecorderOptions options) {
  Triggers triggers;
  const auto watch = [&](const std::optional<Condition>& condition,
                         std::unique_ptr<Trigger>& trigger) -> Result<void> {
    if (!condition) return {};
    auto made = Trigger::Make(*system, *condition, [weak = std::weak_ptr(inbox)] {
      if (const auto alive = weak.lock()) alive->Wake();
    });
    if (!made) return made.error();
    trigger = *std::move(made);
    return {};
  };
  if (auto watched = watch(options.start_when, triggers.start); !watched) return watched.error();
  if (auto watched = watch(options.stop_when, triggers.stop); !watched) return watched.error();
  std::unique_ptr<Files> files;
  if (triggers.start) {
    if (auto is_free = CheckFree(options.files); !is_free) return is_free.error();
  } else {
    auto made = Files::Create(options.files, HeadingFor(system->catalogue(), options.patterns));
    if (!made) return made.error();
    files = *std::move(made);
  }
  if (options.has_log) system->WatchLog();
  return std::unique_ptr<Recorder>(new Recorder(std::move(system), std::move(inbox),
                                                std::move(options), std::move(triggers),
                                                std::move(files)));
}

Recorder::Recorder(std::shared_ptr<SystemAccess> system, std::shared_ptr<Inbox> inbox,
                   RecorderOptions options, Triggers triggers, std::unique_ptr<Files> files)
    : system_(std::move(system)),
      inbox_(std::move(inbox)),
      options_(std::move(options)),
      files_(std::move(files)),
      next_sync_(SteadyClock().Now() + kSyncPeriod),
      triggers_(std::move(triggers)),
      past_(options_.before, options_.before_bytes, WallMinusSteady()),
      armed_(SteadyClock().Now()) {
  if (!triggers_.start) started_ = armed_;
  FollowOnce(false);  // so that the first rows are those of now
  PublishStatus();
  follower_ = std::thread([this] {
    os::NameThisThread("rec follower");
    Follow();
  });
  writer_ = std::thread([this] {
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
  follower_.join();
  EndSubscriptions();
  {
    const std::scoped_lock lock(mutex_);
    is_drained_ = true;
  }
  inbox_->Wake();
  writer_.join();
  triggers_ = {};
  inbox_->Close();
  Result<void> closed;
  if (files_) {
    std::map<std::string, LostRows> rest = inbox_->TakeRest();
    for (const auto& [path, refused] : refused_.rows) rest[path] += refused;
    for (const auto& [path, lost] : rest) {
      if (!status_.failure) (void)files_->WriteLoss(path, lost);
    }
    closed = files_->Close(LossesOfRecording());
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
  status.waiting_bytes = inbox_->waiting_bytes();
  std::error_code failed;
  const std::filesystem::path folder = status.file.parent_path();
  const auto disk = std::filesystem::space(folder.empty() ? "." : folder, failed);
  status.disk_free = failed ? 0 : disk.available;
  return status;
}

std::vector<std::string> Recorder::TakeNotices() {
  std::vector<std::string> all = inbox_->TakeNotices();
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
    if (inbox_->needs_snapshot()) system_->Resync();
    lock.lock();
    stop_.wait_for(lock, kOften, [this] { return !follows_; });
  }
}

/// If it may not wait, leaves out events whose types must be asked for.
void Recorder::FollowOnce(bool may_wait) {
  // Read first: the client has the new catalogue before the inbox counts it.
  const std::uint64_t snapshots = inbox_->snapshots();
  if (has_all_events_ && system_->revision() == revision_ && snapshots == snapshots_) return;
  const Catalogue catalogue = system_->catalogue();
  const bool is_next = snapshots == snapshots_ && catalogue.revision() >= revision_;
  if (!is_next) gone_.clear();
  revision_ = catalogue.revision();
  snapshots_ = snapshots;
  const Choice wanted = Choose(catalogue, options_.patterns);
  FollowTables(wanted.tables, catalogue);
  silent_.clear();
  has_all_events_ = FollowEvents(wanted.events, catalogue, may_wait);
  NoteGoneProcesses(catalogue);
  const std::scoped_lock lock(mutex_);
  status_.tables = tables_.size();
  status_.interfaces = has_all_events_ ? listeners_.size() : wanted.events.size();
}

void Recorder::NoteGoneProcesses(const Catalogue& catalogue) {
  gone_.clear();
  for (const auto& [name, entry] : catalogue.processes()) {
    const ProcessState state = entry.process.state;
    if (state == ProcessState::kLost || state == ProcessState::kLeft) gone_.insert(name);
  }
}

/// True if a process does not have any more what is recorded of it. A new GCM knows no process
/// until the processes join it, so a process that is only missing keeps its subscriptions: they
/// recover by themselves, and count what they lose.
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
    now[TableName(one)] = {one, system_->telemetry().Subscribe(one, inbox_->SinkOf(one))};
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
  std::map<InterfaceName, Listener> now;
  bool has_all = true;
  for (const EventSubscription& one : wanted) {
    std::vector<Fingerprint> types;
    const ProvidedDescription* provided = catalogue.FindProvided(one.provided);
    for (const std::string& name : one.events) {
      const MemberDescription* event =
          provided == nullptr ? nullptr : FindNamed(provided->events, name);
      if (event != nullptr && TakesArgument(event->signature)) types.push_back(event->signature.in);
    }
    auto known = listeners_.extract(one.provided);
    if (!known.empty() && known.mapped().events == one.events && known.mapped().types == types) {
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
    const auto id = system_->Listen(one, inbox_->SinkOf(one, std::move(found)));
    // An incomplete list is asked for again after the next change of the catalogue.
    now[one.provided] = {one.events, is_complete ? types : std::vector<Fingerprint>(), id};
  }
  for (auto& [name, rest] : listeners_) {
    if (IsEnded(catalogue, name.process)) {
      system_->StopListening(rest.id);
    } else {
      now[name] = std::move(rest);
    }
  }
  listeners_ = std::move(now);
  return has_all;
}

/// Asks the process for those that are not known yet, unless it is gone and raises no event anyway.
/// A process that does not answer in time is asked only once for each change of the catalogue.
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
    notices_.push_back("events of " + ToString(events.provided) +
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

/// The writing thread. After a failure, what arrives counts as lost once the inbox is full.
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
      status_.failure = written.error();
      return;
    }
    if (is_last && inbox_->waiting_bytes() == 0) return;
  }
}

Result<void> Recorder::WriteSome() {
  constexpr auto kPatience = 100ms;
  for (Entry& entry : inbox_->Take(kPatience)) {
    if (!files_) {
      past_.Add(std::move(entry), SteadyClock().Now());
    } else if (auto written = Write(std::move(entry)); !written) {
      return written;
    }
  }
  if (!files_) return StartIfDue();
  const SteadyTime now = SteadyClock().Now();
  StopIfDue(now);
  if (now < next_sync_) return {};
  next_sync_ = now + kSyncPeriod;
  return files_->Sync();
}

Result<void> Recorder::Write(Entry entry) {
  const LostRows lost = LostBefore(entry);
  const bool is_wanted = Trim(entry, from_, to_, WallMinusSteady());
  if (LostBefore(entry) != lost || (!is_wanted && lost.all() > 0)) {
    const std::scoped_lock lock(mutex_);
    losses_before_.rows[ToString(std::get<Rows>(entry).source->name)] += lost;
  }
  return is_wanted ? WriteOrCount(entry) : Result<void>();
}

/// Counts what the file cannot hold, such as the rows of one source with a type that is too large,
/// as lost by the recorder, and goes on.
Result<void> Recorder::WriteOrCount(const Entry& entry) {
  const std::uint64_t before = files_->counts().rows;
  auto written = files_->Write(entry);
  if (written || written.error().code != ErrorCode::kInvalid) return written;
  std::string path = "the log";
  const std::scoped_lock lock(mutex_);
  if (const auto* rows = std::get_if<Rows>(&entry)) {
    path = ToString(rows->source->name);
    const std::uint64_t missing = rows->ticks.size() - (files_->counts().rows - before);
    refused_.rows[path].viewer += missing;
  } else if (const auto* event = std::get_if<Event>(&entry)) {
    path = ToString(event->source->name) + "." + event->source->members.at(event->member).name;
    ++refused_.events[path];
  } else if (std::holds_alternative<LogEntry>(entry)) {
    ++refused_.log;
  } else {
    path = "the catalogue";
  }
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
  started_ = start;
  from_ = start - options_.before;
  FileOptions options = options_.files;
  options.past = SteadyClock().Now() - from_;
  auto files = Files::Create(options, HeadingFor(system_->catalogue(), options_.patterns));
  if (!files) return files.error();
  files_ = *std::move(files);
  Losses missing = past_.MissingSince(from_);
  std::map<std::string, LostRows> told = past_.LostBeforeMissingSince(from_);
  for (const auto& [path, lost] : missing.rows) told[path] += lost;
  for (const auto& [path, lost] : told) {
    if (auto written = files_->WriteLoss(path, lost, from_); !written) return written;
  }
  for (const Entry& entry : past_.TakeSince(from_)) {
    if (auto written = WriteOrCount(entry); !written) return written;
  }
  Losses before = LossesUntil(from_);
  before.rows = past_.losses();
  const std::scoped_lock lock(mutex_);
  losses_before_ = std::move(before);
  status_.before_rows_missing = missing.all_rows().viewer;
  status_.before_others_missing = missing.all_events() + missing.log;
  missing_before_ = std::move(missing);
  return {};
}

/// While it waits: keeps the losses of events and of the log, to tell later which of them were
/// before the recording. At most about 100 of them are kept.
void Recorder::KeepLosses() {
  constexpr auto kShortest = 100ms;
  constexpr int kMost = 100;
  const SteadyTime now = SteadyClock().Now();
  const auto pause = std::max<std::chrono::nanoseconds>(kShortest, options_.before / kMost);
  if (!kept_losses_.empty() && now - kept_losses_.back().first < pause) return;
  kept_losses_.emplace_back(now, inbox_->losses());
  constexpr auto kLatest = 1s;  // until a trigger that has fired is known
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

Losses Recorder::LossesOfRecording() const {
  // What is subtracted was counted by the inbox before, so the inbox is read under the lock.
  const std::scoped_lock lock(mutex_);
  Losses losses = inbox_->losses();
  for (const auto& [path, before] : losses_before_.rows) {
    LostRows& lost = losses.rows[path];
    lost.table -= before.table;
    lost.network -= before.network;
    lost.viewer -= before.viewer;
  }
  for (const auto& [path, before] : losses_before_.events) losses.events[path] -= before;
  losses.log -= losses_before_.log;
  losses += refused_;
  losses += missing_before_;
  return losses;
}

void Recorder::PublishStatus() {
  const std::scoped_lock lock(mutex_);
  status_.is_waiting = files_ == nullptr;
  status_.before_bytes = past_.bytes();
  if (files_) status_.counts = files_->counts();
  status_.file = files_ ? files_->file() : options_.files.file;
}

}  // namespace tendon::recording
