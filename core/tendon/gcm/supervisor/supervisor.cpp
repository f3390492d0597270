#include <tendon/gcm/supervisor/supervisor.h>

#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/text.h>
#include <tendon/middleware/hello.h>
#include <tendon/payload/json.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace tendon::server {
namespace {

using std::chrono::milliseconds;

/// A process that did not join in time is terminated. If it has not ended after this time, it is
/// killed.
constexpr std::chrono::seconds kLongestEnd(2);

milliseconds TimeoutOf(std::chrono::nanoseconds asked) {
  constexpr milliseconds kUsual(6000);
  constexpr std::chrono::hours kLongest(1);
  if (asked <= std::chrono::nanoseconds(0)) return kUsual;
  return std::chrono::ceil<milliseconds>(std::min<std::chrono::nanoseconds>(asked, kLongest));
}

/// Returns the result of `action`. Converts its exceptions (file errors, out of memory) to an
/// Error.
template <typename T, typename Action>
Result<T> Guarded(const Action& action) {
  try {
    return action();
  } catch (const std::exception& failure) {
    return Error{ErrorCode::kFailed, failure.what()};
  }
}

std::string Named(const std::string& process) { return "process '" + process + "'"; }

Error Refused(const std::string& process, const std::string& why) {
  return {ErrorCode::kFailed, Named(process) + " " + why};
}

}  // namespace

Supervisor::Supervisor(Parts parts, Locked locked)
    : parts_(std::move(parts)), locked_(std::move(locked)) {}

void Supervisor::ExecuteOrder(const message::ProcessOrder& order, const std::string& who,
                              Done done) {
  if (auto valid = CheckName("process", order.process); !valid) {
    return Reply(std::move(done), valid.error());
  }
  if (order.verb == ProcessVerb::kStart) return Start(order, who, std::move(done));
  Kill(order.process, TimeoutOf(order.timeout), std::move(done));
}

void Supervisor::Tick() {
  std::vector<std::string> names;  // a copy: Check() may remove entries
  for (const auto& [process, child] : children_) names.push_back(process);
  for (const std::string& process : names) Check(process, children_.at(process));
  ShortenLogs();
}

void Supervisor::ShortenLogs() {
  constexpr std::chrono::seconds kPause(1);
  const SteadyTime now = parts_.clock.Now();
  if (now < next_log_check_) return;
  next_log_check_ = now + kPause;
  for (const auto& [process, child] : children_) {
    if (child.phase != Phase::kRunning) continue;
    worker_.Post([launcher = parts_.launcher, name = process] { launcher->ShortenLog(name); });
  }
}

void Supervisor::NoteChange(const std::string& process) {
  const auto child = children_.find(process);
  if (child != children_.end()) child->second.is_changed = true;
}

message::Children Supervisor::children() const {
  message::Children all;
  for (const auto& [process, child] : children_) {
    if (!child.is_unwanted) all.processes.push_back({process, child.restart});
  }
  return all;
}

Result<void> Supervisor::CheckUndo(const message::HistoryEntry& step) const {
  const std::string& process = step.lifecycle.process;
  if (auto ours = CheckKill(process); !ours) return ours;
  const ProcessEntry* entry = parts_.registry.catalogue().FindProcess(process);
  if (entry == nullptr || entry->components.empty()) return {};
  return Refused(process, "now has components, such as " + entry->components.begin()->first);
}

void Supervisor::Undo(const message::HistoryEntry& step, std::chrono::nanoseconds timeout,
                      Done done) {
  Kill(step.lifecycle.process, TimeoutOf(timeout), std::move(done));
}

void Supervisor::Start(const message::ProcessOrder& order, const std::string& who, Done done) {
  if (auto free = CheckStart(order.process); !free) return Reply(std::move(done), free.error());
  Child& child = children_[order.process];
  child = {.restart = order.restart,
           .timeout = TimeoutOf(order.timeout),
           .who = who,
           .done = std::move(done)};
  Launch(order.process, child);
}

/// Checks that a process can be started. If the restart of a process is pending, it may be started
/// at once, and counts as a new process.
Result<void> Supervisor::CheckStart(const std::string& process) const {
  if (process == kGcmName) {
    return Error{ErrorCode::kInvalid,
                 "'" + process + "' is the name of the GCM itself; choose another name"};
  }
  const auto* const entry = parts_.registry.catalogue().FindProcess(process);
  if (entry != nullptr && IsPresent(entry->process)) {
    return Error{ErrorCode::kExists, Named(process) + " is already running: host " +
                                         entry->process.host + " pid " +
                                         std::to_string(entry->process.pid)};
  }
  const auto child = children_.find(process);
  if (child == children_.end() || child->second.phase == Phase::kPausing) return {};
  const auto& program = child->second.program;
  const std::string pid = program ? " as pid " + std::to_string(program->pid()) : "";
  return Error{ErrorCode::kExists, Named(process) + " was already started" + pid +
                                       ", but has not joined; to end the process: gcm kill " +
                                       process};
}

Result<void> Supervisor::CheckKill(const std::string& process) const {
  const auto found = children_.find(process);
  if (found != children_.end()) {
    const Child& child = found->second;
    if (child.is_unwanted) return Refused(process, "is already being ended");
    const bool is_between = child.phase == Phase::kStarting || child.phase == Phase::kEnded ||
                            child.phase == Phase::kExamining;
    if (is_between) return Refused(process, "is starting or ending at the moment; try again");
    return {};
  }
  const auto entry = LookUpProcess(parts_.registry.catalogue(), process);
  if (!entry) return entry.error();
  const ProcessDescription& description = (*entry)->process;
  if (!IsPresent(description)) return Refused(process, "is already gone");
  return Refused(process,
                 "was not started by this GCM: end the process where it was started, or on host " +
                     description.host + " by: kill " + std::to_string(description.pid));
}

void Supervisor::Kill(const std::string& process, milliseconds timeout, Done done) {
  if (auto ours = CheckKill(process); !ours) return Reply(std::move(done), ours.error());
  Child& child = children_.at(process);
  if (child.phase == Phase::kPausing) {
    Drop(process, "was ended on request, and is not restarted");
    return Reply(std::move(done), None{});
  }
  if (child.done) Reply(child.done, Refused(process, "was ended on request before it joined"));
  child.done = std::move(done);
  child.is_unwanted = true;
  child.phase = Phase::kEnding;
  child.until = parts_.clock.Now() + timeout;
  child.program->Terminate();
}

void Supervisor::Launch(const std::string& process, Child& child) {
  child.phase = Phase::kStarting;
  child.is_changed = false;
  child.fault.clear();
  parts_.registry.Expect(process, 0);
  const Launcher::Order order{process, child.timeout, child.system};
  worker_.Post([launcher = parts_.launcher, locked = locked_, order] {
    const auto program =
        Guarded<std::shared_ptr<StartedProcess>>([&] { return launcher->Start(order); });
    locked([&](Supervisor& self) { self.Begin(order.process, program); });
  });
}

void Supervisor::Begin(const std::string& process,
                       const Result<std::shared_ptr<StartedProcess>>& program) {
  Child& child = children_.at(process);  // the entry is not removed during a launch
  if (program) {
    parts_.registry.Expect(process, (*program)->pid());
  } else {
    parts_.registry.GiveUp(process);
  }
  if (!program && child.is_known) return Drop(process, program.error().message);
  if (!program) {
    Reply(child.done, program.error());
    children_.erase(process);
    return;
  }
  child.program = *program;
  child.phase = Phase::kJoining;
  child.begin = parts_.clock.Now();
  child.until = child.begin + child.timeout;
}

void Supervisor::Check(const std::string& process, Child& child) {
  const bool has_program = child.phase == Phase::kJoining || child.phase == Phase::kRunning ||
                           child.phase == Phase::kEnding;
  if (has_program) {
    if (const auto end = child.program->Ended()) {
      child.end = *end;
      child.phase = Phase::kEnded;
      parts_.registry.GiveUp(process);  // has an effect only if the process has not joined
    }
  }
  const bool is_over = parts_.clock.Now() >= child.until;
  switch (child.phase) {
    case Phase::kJoining:
      if (IsMember(process, child)) return OnJoined(process, child);
      if (is_over) EndFaulty(child, "has not joined within " + Milliseconds(child.timeout));
      return;
    case Phase::kEnding:
      if (is_over) child.program->Kill();
      return;
    case Phase::kEnded:
      if (!IsMember(process, child)) Examine(process, child);
      return;
    case Phase::kPausing:
      if (is_over) Launch(process, child);
      return;
    case Phase::kStarting:
    case Phase::kRunning:
    case Phase::kExamining:
      return;
  }
}

void Supervisor::OnJoined(const std::string& process, Child& child) {
  child.phase = Phase::kRunning;
  child.is_known = true;
  if (!child.done) return;
  message::HistoryEntry step{.verb = std::string(ToString(ProcessVerb::kStart)),
                             .lifecycle = {.process = process},
                             .who = child.who,
                             .when = WallTime(),
                             .instance = InstanceOf(parts_.registry.catalogue(), process)};
  parts_.history.Record(std::move(step),
                        [done = std::exchange(child.done, nullptr)] { done(None{}); });
}

/// Asks a process to end because it has not joined in time.
void Supervisor::EndFaulty(Child& child, const std::string& why) {
  child.fault = why;
  child.phase = Phase::kEnding;
  child.until = parts_.clock.Now() + kLongestEnd;
  child.program->Terminate();
}

void Supervisor::Examine(const std::string& process, Child& child) {
  child.phase = Phase::kExamining;
  worker_.Post([launcher = parts_.launcher, locked = locked_, process] {
    const auto log =
        Guarded<ProcessLog>([&]() -> Result<ProcessLog> { return launcher->LogOf(process); });
    locked([&](Supervisor& self) { self.OnExamined(process, log ? *log : ProcessLog{}); });
  });
}

/// Decides what to do after the end of a process: reply to the request, restart the process, or
/// report the end.
void Supervisor::OnExamined(const std::string& process, const ProcessLog& log) {
  Child& child = children_.at(process);
  const std::string place = "; its log: " + log.path;
  const bool is_faulty = !child.fault.empty();
  if (child.is_unwanted || !child.is_known) {
    const std::string why = is_faulty ? child.fault + ", so the GCM has ended it"
                                      : child.end.how + " before it had joined";
    const std::string words = log.last_lines.empty() ? "" : "; its last output: " + log.last_lines;
    Reply(child.done,
          child.is_unwanted ? Result<None>(None{}) : Refused(process, why + words + place));
    children_.erase(process);
    return;
  }
  if (!child.end.is_failure && !is_faulty) return Drop(process, child.end.how + " by itself");
  const std::string how = (is_faulty ? child.fault : child.end.how) + place;
  if (child.restart == RestartPolicy::kNever) {
    return Drop(process, how + "; it is not restarted (restart never)");
  }
  ScheduleRestart(process, child, how);
}

void Supervisor::ScheduleRestart(const std::string& process, Child& child, const std::string& how) {
  const SteadyTime now = parts_.clock.Now();
  const auto pause = child.schedule.PauseAfter(child.begin, now);
  if (!pause) {
    return Drop(process,
                how + "; it is not restarted, because it has failed " +
                    std::to_string(RestartSchedule::kMaxFailures) +
                    " times within a minute; to start it when the fault is repaired: gcm apply");
  }
  Report(process, how + "; it is restarted in " + Milliseconds(*pause));
  if (child.is_changed || !child.system) child.system = SystemWith(process);
  child.phase = Phase::kPausing;
  child.until = now + *pause;
}

void Supervisor::Drop(const std::string& process, const std::string& how) {
  Report(process, how);
  children_.erase(process);
}

/// Writes a text about the process to the log. Viewers also see the text if the catalogue has the
/// process.
void Supervisor::Report(const std::string& process, const std::string& what) {
  if (parts_.registry.SetReason(process, what)) return;  // then the server logs the change
  parts_.deferred.Add(
      [text = Named(process) + " " + what] { Log(LogLevel::kWarning, "gcm", text); });
}

bool Supervisor::IsMember(const std::string& process, const Child& child) const {
  const auto* const entry = parts_.registry.catalogue().FindProcess(process);
  return entry != nullptr && IsPresent(entry->process) &&
         entry->process.pid == child.program->pid() && entry->process.host == os::HostName();
}

/// Returns the last known components of the process, for its restart. Returns nothing if the
/// catalogue does not have the process.
std::optional<SystemFile> Supervisor::SystemWith(const std::string& process) const {
  const SystemFile system =
      SystemOf(parts_.registry.catalogue(), process, AbsentProcesses::kIncluded).file;
  for (const SystemFile::Process& one : system.processes) {
    if (one.name == process) return system;
  }
  return std::nullopt;
}

void Supervisor::Reply(Done done, Result<None> result) {
  parts_.deferred.Add([done = std::move(done), result = std::move(result)] { done(result); });
}

}  // namespace tendon::server
