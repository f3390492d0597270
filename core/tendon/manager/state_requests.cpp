#include <tendon/manager/state_requests.h>

#include <tendon/manager/local_manager.h>
#include <tendon/task/task.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace tendon {
namespace {

// These requests do not wait for their effect.
constexpr auto kStart = [](Component& component) { return component.Start(kNoWait); };
constexpr auto kSuspend = [](Component& component) { return component.Suspend(kNoWait); };
constexpr auto kStop = [](Component& component) { return component.Stop(kNoWait); };

Error RequestInProgress(const std::string& component) {
  return {ErrorCode::kTimeout, "component '" + component +
                                   "' is still busy with an earlier request; it may be in "
                                   "its Configure(), Startup() or Cleanup()"};
}

/// Calls `body` while the lock is released, so that other threads can take it.
Result<void> WithoutLock(std::unique_lock<std::recursive_mutex>& lock, const auto& body) {
  struct UnlockScope {
    explicit UnlockScope(std::unique_lock<std::recursive_mutex>& given) : held(given) {
      held.unlock();
    }
    ~UnlockScope() { held.lock(); }
    std::unique_lock<std::recursive_mutex>& held;
  };
  const UnlockScope unlock(lock);
  return body();
}

}  // namespace

StateRequests::StateRequests(Manager manager) : manager_(std::move(manager)) {}

Result<void> StateRequests::Start(const std::string& component, std::chrono::nanoseconds timeout) {
  return RequestState(component, kStart, ComponentState::kActive, timeout);
}

Result<void> StateRequests::Start(const std::string& component, std::chrono::nanoseconds timeout,
                                  std::function<bool()> proceed) {
  const auto start = [proceed = std::move(proceed)](Component& one) {
    return one.Start(kNoWait, proceed);
  };
  return RequestState(component, start, ComponentState::kActive, timeout);
}

Result<void> StateRequests::Suspend(const std::string& component,
                                    std::chrono::nanoseconds timeout) {
  return RequestState(component, kSuspend, ComponentState::kSuspended, timeout);
}

Result<void> StateRequests::Stop(const std::string& component, std::chrono::nanoseconds timeout) {
  if (timeout <= kNoWait) {
    return RequestState(component, kStop, ComponentState::kFinished, timeout);
  }
  const auto found = manager_.find(component);
  if (!found) return found.error();
  const SteadyTime deadline = DeadlineAfter(timeout);
  (void)StopInOrder([&](const Component& one) { return RunsAfter(one, **found); }, deadline);
  const std::chrono::nanoseconds left = std::max<std::chrono::nanoseconds>(
      RequestSerializer::kShortest, deadline - SteadyClock().Now());
  const auto stopped = RequestStateOfAll({*found}, kStop, ComponentState::kFinished, left);
  if (stopped) {
    LetExecute(**found,
               std::min<SteadyTime>(deadline, SteadyClock().Now() + LocalManager::kDrainTimeout));
  }
  return stopped;
}

Result<void> StateRequests::TransitionTo(const std::string& component, ComponentState wanted,
                                         std::chrono::nanoseconds timeout) {
  if (!IsRunning(wanted)) return {};
  auto done = Start(component, timeout);
  if (wanted == ComponentState::kActive) return done;
  const auto is_at_rest = [&] {
    const auto found = manager_.find(component);
    return !found || (*found)->is_at_rest();
  };
  if (done) done = Suspend(component, timeout);
  if (done || is_at_rest()) return done;
  const auto stopped = Stop(component, kDefaultTimeout);
  const std::string before = "'" + component + "' could not be suspended: " + done.error().message;
  if (stopped || is_at_rest()) {
    return Error{done.error().code, before + "; it was stopped instead"};
  }
  return Error{done.error().code,
               before + "; it may still run, because it does not stop: " + stopped.error().message};
}

Result<void> StateRequests::StartAll(std::chrono::nanoseconds timeout) {
  Components all = StartOrder();
  std::erase_if(all, [](const auto& one) { return one->state() == ComponentState::kActive; });
  return RequestStateOfAll(all, kStart, ComponentState::kActive, timeout);
}

Result<void> StateRequests::SuspendAll(std::chrono::nanoseconds timeout) {
  Components all = StartOrder();
  std::reverse(all.begin(), all.end());
  std::erase_if(all, [](const auto& one) { return one->state() != ComponentState::kActive; });
  return RequestStateOfAll(all, kSuspend, ComponentState::kSuspended, timeout);
}

Result<void> StateRequests::StopAll(std::chrono::nanoseconds timeout) {
  const auto any = [](const Component& /*one*/) { return true; };
  if (timeout > kNoWait) return StopInOrder(any, DeadlineAfter(timeout));
  Components all;
  for (OrderlyShutdown::Member& one : EndOrder(any)) all.push_back(std::move(one.component));
  std::erase_if(all, [this](const auto& one) { return IsAtRest(*one); });
  return RequestStateOfAll(all, kStop, ComponentState::kFinished, timeout);
}

Result<void> StateRequests::StopInOrder(const IsMeant& is_meant, SteadyTime deadline) {
  const auto stop = [this](const ComponentPointer& one) {
    return RequestStop(one, SteadyClock().Now());
  };
  OrderlyShutdown end(EndOrder(is_meant),
                      {.is_at_rest = [this](const Component& one) { return IsAtRest(one); },
                       .stop = stop,
                       .has_calls_under_way = manager_.has_calls_under_way});
  return end.Run(deadline);
}

/// Returns true if the component is at rest and no request for it is in progress. A request in
/// progress might start the component.
bool StateRequests::IsAtRest(const Component& component) const {
  const auto lock = manager_.lock();
  return component.is_at_rest() && !serializer_.IsInUse(component);
}

void StateRequests::LetExecute(const Component& client, SteadyTime deadline) const {
  constexpr std::chrono::microseconds kBetweenLooks(500);
  while (manager_.has_calls_under_way(client)) {
    if (SteadyClock().Now() >= deadline) return OrderlyShutdown::LogNotExecuted(client);
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

Result<void> StateRequests::WaitFor(const std::string& component, ComponentState state,
                                    std::chrono::nanoseconds timeout) const {
  const auto found = manager_.find(component);
  return found ? (*found)->WaitFor(state, timeout) : found.error();
}

Result<void> StateRequests::WaitForAll(ComponentState state,
                                       std::chrono::nanoseconds timeout) const {
  const SteadyTime deadline = DeadlineAfter(timeout);
  for (const auto& one : StartOrder()) {
    const auto reached = one->WaitFor(state, std::max(kNoWait, deadline - SteadyClock().Now()));
    if (!reached) return reached;
  }
  return {};
}

Result<void> StateRequests::RequestState(const std::string& component, const Request& request,
                                         ComponentState wanted, std::chrono::nanoseconds timeout) {
  const auto found = manager_.find(component);
  return found ? RequestStateOfAll({*found}, request, wanted, timeout) : found.error();
}

Result<void> StateRequests::RequestStateOfAll(const Components& components, const Request& request,
                                              ComponentState wanted,
                                              std::chrono::nanoseconds timeout) {
  const SteadyTime deadline = DeadlineAfter(timeout);
  Result<void> outcome;
  for (const auto& one : components) {
    Result<void> done = MakeRequest(one, request, deadline);
    if (done && timeout > kNoWait) {
      done = one->WaitForEffect(wanted, std::max(kNoWait, deadline - SteadyClock().Now()));
    }
    if (!done && outcome) outcome = done;
  }
  return outcome;
}

Result<void> StateRequests::MakeRequest(const ComponentPointer& component, const Request& request,
                                        SteadyTime deadline) {
  auto lock = manager_.lock();
  const RequestSerializer::Turn turn(serializer_, *component, lock, deadline);
  if (!turn.is_ours()) return RequestInProgress(component->name());
  const auto present = manager_.find(component->name());
  if (!present || *present != component) {
    return Error{ErrorCode::kNotFound,
                 "component '" + component->name() + "' was removed by another request"};
  }
  return WithoutLock(lock, [&] { return request(*component); });
}

Result<void> StateRequests::RequestStop(const ComponentPointer& component, SteadyTime deadline) {
  return MakeRequest(component, kStop, deadline);
}

Result<void> StateRequests::RequireNoRequest(const Component& component) const {
  if (serializer_.IsInUse(component)) return RequestInProgress(component.name());
  return {};
}

StateRequests::Components StateRequests::StartOrder() const {
  const auto lock = manager_.lock();
  return manager_.order().StartOrder();
}

std::vector<OrderlyShutdown::Member> StateRequests::EndOrder(const IsMeant& is_meant) const {
  const auto lock = manager_.lock();
  return manager_.order().EndOrder(is_meant);
}

}  // namespace tendon
