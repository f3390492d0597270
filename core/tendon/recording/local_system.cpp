#include <tendon/recording/local_system.h>

#include <tendon/base/os/process.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/process/telemetry/make_telemetry_client.h>

#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace tendon::recording {
namespace {

constexpr const char* kProgram = "recorder";

ProcessDescription DescriptionOf(const LocalAccess& process) {
  ProcessDescription description;
  description.name = process.process();
  description.instance = process.instance();
  description.host = os::HostName();
  description.pid = os::ProcessId();
  description.address = LocalAccess::kAddress;
  return description;
}

Hello HelloOfRecorder() {
  const auto cookie = LoopbackCookie();  // if there is none, the process refuses the request, and
                                         // the refusal contains the remedy
  return {.instance = os::RandomNumber(), .name = kProgram, .cookie = cookie ? *cookie : 0};
}

}  // namespace

LocalSystem::LocalSystem(std::shared_ptr<LocalAccess> process,
                         std::shared_ptr<GcmListener> listener, std::chrono::milliseconds timeout)
    : process_(std::move(process)),
      listener_(std::move(listener)),
      timeout_(timeout),
      middleware_(process_->MakeMiddleware()) {
  const auto resolve = [this](const std::string& name) -> Result<ProcessDescription> {
    if (auto known = CheckProcess(name); !known) return known.error();
    return DescriptionOf(*process_);
  };
  const auto address_of = [this](const std::string& name) -> Result<std::string> {
    if (auto known = CheckProcess(name); !known) return known.error();
    return std::string(LocalAccess::kAddress);
  };
  const auto events_of = [this](const EventSubscription& wanted) {
    const std::scoped_lock lock(mutex_);
    return LookUpEvents(catalogue_, wanted);
  };
  links_ = std::make_shared<client::ProcessLinks>(
      *middleware_, resolve,
      client::ProcessLinks::Options{.name = kProgram, .role = Role::kViewer});
  requests_ = std::make_shared<client::ProcessRequests>(links_, timer_, timeout_);
  events_ = std::make_shared<client::EventFeed>(links_, timer_, events_of, kProgram, timeout_);
  links_->SetNoticeListener(events_);
  telemetry_ = MakeTelemetryClient(middleware_, address_of, HelloOfRecorder());
  constexpr int kTries = 40;
  constexpr std::chrono::milliseconds kPause(5);
  for (int i = 0; i < kTries && revision() == 0; ++i) std::this_thread::sleep_for(kPause);
}

LocalSystem::~LocalSystem() {
  {
    const std::scoped_lock lock(mutex_);
    log_.reset();
  }
  events_->Stop();
  links_->Stop();
  timer_->Stop();
  telemetry_.reset();
}

std::uint64_t LocalSystem::revision() {
  ProcessContent now;
  const bool is_known = process_->TryDescribe(now);
  std::unique_lock lock(mutex_);
  const bool is_first = catalogue_.revision() == 0;
  if (!is_known || (!is_first && now == content_)) return catalogue_.revision();
  std::vector<CatalogueChange> changes = Differences(content_, now);
  if (is_first) {
    CatalogueChange process;
    process.kind = CatalogueChange::Kind::kProcess;
    process.processes = {DescriptionOf(*process_)};
    process.processes.front().plugins = now.plugins;
    changes.insert(changes.begin(), std::move(process));
  }
  for (CatalogueChange& change : changes) {
    change.process = process_->process();
    change.revision = catalogue_.revision() + 1;
    (void)catalogue_.Apply(change);
  }
  content_ = std::move(now);
  const std::uint64_t revision = catalogue_.revision();
  const Catalogue snapshot = is_first ? catalogue_ : Catalogue();
  lock.unlock();
  if (is_first) {
    listener_->OnSnapshot(snapshot);
  } else if (!changes.empty()) {
    listener_->OnChanges(changes);
  }
  return revision;
}

Catalogue LocalSystem::catalogue() const {
  const std::scoped_lock lock(mutex_);
  return catalogue_;
}

std::optional<Error> LocalSystem::WhyUnknown() {
  if (revision() != 0) return std::nullopt;
  return Error{ErrorCode::kFailed, "process '" + process_->process() +
                                       "' is busy with a request, so its tables are not known yet; "
                                       "try again"};
}

GcmClient::ListenerId LocalSystem::Listen(const EventSubscription& events,
                                          std::shared_ptr<EventSink> sink) {
  return events_->Listen(events, std::move(sink));
}

void LocalSystem::StopListening(GcmClient::ListenerId id) { events_->End(id); }

void LocalSystem::ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                                 std::shared_ptr<EventSink> sink,
                                 std::function<void(const PastEvents&)> done) {
  events_->ReadPast(events, last, std::move(sink), std::move(done));
}

Result<message::ReadLogReply> LocalSystem::ReadLog(const std::string& process,
                                                   const message::ReadLog& wanted) {
  return Wait<message::ReadLogReply>(
      timeout_, [&](auto handler) { requests_->ReadLog(process, wanted, handler); });
}

Result<message::ProcessHistoryState> LocalSystem::GetProcessHistory(const std::string& process) {
  return Wait<message::ProcessHistoryState>(
      timeout_, [&](auto handler) { requests_->GetProcessHistory(process, handler); });
}

Result<Schema> LocalSystem::FindSchema(const std::string& process, Fingerprint type) {
  return Wait<Schema>(timeout_,
                      [&](auto handler) { requests_->GetSchema(process, type, handler); });
}

void LocalSystem::Resync() { listener_->OnSnapshot(catalogue()); }

void LocalSystem::WatchLog() {
  const std::scoped_lock lock(mutex_);
  log_.emplace([this](LogLevel level, std::string_view source, std::string_view text) {
    OnLog(level, source, text);
  });
  listener_->OnLog({.records = {}, .lost = 0, .is_current = true});
}

void LocalSystem::OnLog(LogLevel level, std::string_view source, std::string_view text) {
  const LogBatch batch{.records = {{.time = WallTime(),
                                    .level = level,
                                    .process = process_->process(),
                                    .source = std::string(source),
                                    .text = std::string(text)}},
                       .lost = 0,
                       .is_current = true};
  listener_->OnLog(batch);
}

Result<void> LocalSystem::CheckProcess(const std::string& process) const {
  if (process == process_->process()) return {};
  return Error{ErrorCode::kNotFound, "a recorder in process '" + process_->process() +
                                         "' reaches only this process, not '" + process + "'"};
}

}  // namespace tendon::recording
