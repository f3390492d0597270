#include <tendon/gcm/system/client_executor.h>

#include <tendon/gcm/lookup.h>
#include <tendon/payload/json.h>

#include <optional>
#include <thread>

namespace tendon {
namespace {

using Kind = PlanStep::Kind;

/// The executor waits this much longer than the client, because the error of the client is more
/// precise.
constexpr std::chrono::milliseconds kLonger(500);

/// Time between two checks of the catalogue.
constexpr std::chrono::milliseconds kLook(20);

/// Checks that the interfaces of `ends` are connected; the error says why not.
Result<void> CheckConnected(const Catalogue& catalogue, const message::ConnectionEnds& ends) {
  const auto refuse = [&](const std::string& why) {
    return Error{ErrorCode::kFailed, "not started, because " + ToString(ends.required) +
                                         " is not connected to " + ToString(ends.provided) +
                                         (why.empty() ? "" : ": " + why)};
  };
  const auto* now = catalogue.FindConnection(ends.required);
  if (now == nullptr) return refuse("");
  if (now->provided != ends.provided) return refuse("but to " + ToString(now->provided));
  return now->state == ConnectionState::kActive ? Result<void>() : refuse(now->reason);
}

bool IsOutcomeUnknown(const Error& error) {
  return error.code == ErrorCode::kTimeout || error.code == ErrorCode::kUnreachable;
}

/// Returns true if the component is already in the state to which `verb` leads.
bool IsSo(const Catalogue& catalogue, LifecycleVerb verb, const PlanStep& step) {
  const auto* now = catalogue.FindComponent(step.process, step.component.name);
  if (now == nullptr) return verb == LifecycleVerb::kRemove;
  if (verb == LifecycleVerb::kStop) return !IsRunning(now->state);
  if (verb == LifecycleVerb::kStart) return now->state == ComponentState::kActive;
  return verb == LifecycleVerb::kSuspend && now->state == ComponentState::kSuspended;
}

/// Returns the result of `read(catalogue)` for the current catalogue.
template <typename Read>
auto Seen(const GcmClient& client, const Read& read) {
  decltype(read(Catalogue())) result{};
  client.WithCatalogue([&](const Catalogue& catalogue) { result = read(catalogue); });
  return result;
}

}  // namespace

Result<void> ClientExecutor::TakeLock() {
  return Wait<void>(timeout_ + kLonger,
                    [&](auto handler) { client_.TakePlanLock(std::move(handler)); });
}

Result<void> ClientExecutor::Begin() {
  const auto begun = TakeLock();
  has_lock_ = begun.ok();
  if (begun) return begun;
  const ErrorCode code = begun.error().code;
  if (code == ErrorCode::kDenied) return {};
  if (code != ErrorCode::kFailed) client_.ReleasePlanLock();  // the GCM may have granted the lock
  return begun;
}

void ClientExecutor::End() {
  client_.ReleasePlanLock();
  has_lock_ = false;
}

/// Requests the lock again. Called before each step, because the GCM releases the lock when the
/// link breaks.
Result<void> ClientExecutor::KeepLock() {
  if (!has_lock_) return {};
  const auto kept = TakeLock();
  if (kept || kept.error().code != ErrorCode::kFailed) return kept;
  return Error{kept.error().code, "the plan lost its lock when the connection to the GCM broke; " +
                                      kept.error().message};
}

Result<void> ClientExecutor::Execute(const PlanStep& step) {
  if (auto kept = KeepLock(); !kept) return kept;
  if (auto checked = CheckInstance(step); !checked) return checked;
  switch (step.kind) {
    case Kind::kStop:
      return ExecuteLifecycleOrder(LifecycleVerb::kStop, step);
    case Kind::kSuspend:
      return ExecuteLifecycleOrder(LifecycleVerb::kSuspend, step);
    case Kind::kDisconnect:
      return Wait<void>(timeout_ + kLonger,
                        [&](auto handler) { client_.Disconnect(step.ends.required, handler); });
    case Kind::kRemove:
      return ExecuteLifecycleOrder(LifecycleVerb::kRemove, step);
    case Kind::kStartProcess:
      return ExecuteProcessOrder(ProcessVerb::kStart, step);
    case Kind::kEndProcess:
      return ExecuteProcessOrder(ProcessVerb::kKill, step);
    case Kind::kConfigure:
      return ExecuteLifecycleOrder(LifecycleVerb::kConfigure, step);
    case Kind::kCreate:
      return ExecuteLifecycleOrder(LifecycleVerb::kCreate, step);
    case Kind::kConnect:
    case Kind::kReplace:
      return Connect(step);
    case Kind::kStart:
    case Kind::kStartSuspended:
      break;
  }
  if (auto connected = AwaitConnections(step); !connected) return connected;
  return step.kind == Kind::kStart ? ExecuteLifecycleOrder(LifecycleVerb::kStart, step)
                                   : StartSuspended(step);
}

Result<void> ClientExecutor::CheckInstance(const PlanStep& step) const {
  const bool is_of_connection = step.process.empty();
  const std::string& process = is_of_connection ? step.ends.required.process : step.process;
  const auto instance_of = [&](const Catalogue& now) { return InstanceOf(now, process); };
  if (step.instance == 0 || Seen(client_, instance_of) == step.instance) return {};
  return Error{ErrorCode::kFailed, "process '" + process +
                                       "' was restarted or has ended since the plan was made; make "
                                       "another plan"};
}

/// Waits until the connections that the step needs are active. A connection that was just requested
/// may not be active yet.
Result<void> ClientExecutor::AwaitConnections(const PlanStep& step) const {
  for (const message::ConnectionEnds& ends : step.needs) {
    const auto check = [&](const Catalogue& now) { return CheckConnected(now, ends); };
    Result<void> connected = Seen(client_, check);
    for (auto waited = kLook; !connected && waited <= timeout_; waited += kLook) {
      std::this_thread::sleep_for(kLook);
      connected = Seen(client_, check);
    }
    if (!connected) return connected;
  }
  return {};
}

Result<void> ClientExecutor::Connect(const PlanStep& step) {
  const InterfaceName& required = step.ends.required;
  const InterfaceName& provided = step.ends.provided;
  const WhenConnected when_connected =
      step.kind == Kind::kReplace ? WhenConnected::kReplace : WhenConnected::kRefuse;
  const auto made = Wait<ConnectionDescription>(
      GcmClient::kReplaceTimeouts * timeout_ + kLonger,
      [&](auto handler) { client_.Connect(required, provided, handler, when_connected); });
  if (made || IsMadeByOthers(step.ends, made.error().code)) return {};
  return made.error();
}

/// Called when a connection was refused. Returns true if the connection exists nevertheless: the
/// GCM may have restored it when a component returned. Waits up to kLonger for this.
bool ClientExecutor::IsMadeByOthers(const message::ConnectionEnds& ends, ErrorCode refusal) const {
  if (refusal != ErrorCode::kExists && refusal != ErrorCode::kFailed) return false;
  for (auto waited = kLook; waited <= kLonger; waited += kLook) {
    const auto provider = Seen(client_, [&](const Catalogue& catalogue) {
      const auto* now = catalogue.FindConnection(ends.required);
      return now == nullptr ? std::nullopt : std::optional(now->provided);
    });
    if (provider) return provider == ends.provided;
    std::this_thread::sleep_for(kLook);
  }
  return false;
}

Result<void> ClientExecutor::ExecuteProcessOrder(ProcessVerb verb, const PlanStep& step) {
  return Wait<void>(GcmClient::kProcessOrderTimeouts * timeout_ + kLonger, [&](auto handler) {
    message::ProcessOrder order{.verb = verb, .process = step.process};
    if (verb == ProcessVerb::kStart) order.restart = step.restart;
    client_.ExecuteProcessOrder(std::move(order), handler);
  });
}

Result<void> ClientExecutor::ExecuteLifecycleOrder(LifecycleVerb verb, const PlanStep& step) {
  message::LifecycleOrder order{.verb = verb,
                                .process = step.process,
                                .instance = step.instance,
                                .component = step.component.name};
  if (verb == LifecycleVerb::kCreate) {
    order.class_name = step.component.class_name;
    order.library = step.component.library;
    if (step.component.thread) order.thread = ToJson(*step.component.thread);
    order.leader = step.component.runs_after;
  }
  if (verb == LifecycleVerb::kStart) order.is_strict = step.is_strict;
  if (verb == LifecycleVerb::kCreate || verb == LifecycleVerb::kConfigure) {
    order.configuration = step.component.configuration;
    order.based_on = step.based_on;
  }
  const auto made =
      Wait<void>(GcmClient::kLifecycleOrderTimeouts * timeout_ + kLonger,
                 [&](auto handler) { client_.ExecuteLifecycleOrder(order, handler); });
  const bool is_refused = !made && made.error().code == ErrorCode::kFailed;
  const auto is_so = [&](const Catalogue& now) { return IsSo(now, verb, step); };
  return is_refused && Seen(client_, is_so) ? Result<void>() : made;
}

/// Starts a component and then suspends it. If it cannot be suspended, stops it, because it must
/// not run.
Result<void> ClientExecutor::StartSuspended(const PlanStep& step) {
  const auto started = ExecuteLifecycleOrder(LifecycleVerb::kStart, step);
  if (!started && !IsOutcomeUnknown(started.error())) return started;
  const auto done = started ? ExecuteLifecycleOrder(LifecycleVerb::kSuspend, step) : started;
  if (done) return done;
  const auto stopped = ExecuteLifecycleOrder(LifecycleVerb::kStop, step);
  const std::string before = "the component could not be suspended: " + done.error().message;
  if (stopped) return Error{done.error().code, before + "; it was stopped instead"};
  return Error{done.error().code,
               before + "; the component may still run, because it could not be stopped: " +
                   stopped.error().message};
}

}  // namespace tendon
