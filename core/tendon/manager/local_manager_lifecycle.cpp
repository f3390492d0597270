#include <tendon/base/log.h>
#include <tendon/manager/component_order.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/threaded_task.h>

#include <algorithm>
#include <thread>
#include <utility>

// The requests of a LocalManager that change the state of its components. ComponentOrder says in
// which order.

namespace tendon {
namespace {

// These functions make a request, but do not wait for its effect.
Result<void> Start(Component& component) { return component.Start(kNoWait); }
Result<void> Suspend(Component& component) { return component.Suspend(kNoWait); }
Result<void> Stop(Component& component) { return component.Stop(kNoWait); }

/// Calls `body` while the lock is released, so that other threads can take it.
Result<void> WithoutLock(std::unique_lock<std::recursive_mutex>& lock, const auto& body) {
  struct Relock {
    explicit Relock(std::unique_lock<std::recursive_mutex>& given) : held(given) { held.unlock(); }
    ~Relock() { held.lock(); }
    std::unique_lock<std::recursive_mutex>& held;
  };
  const Relock relock(lock);
  return body();
}

}  // namespace

Result<void> LocalManager::RunAfter(const std::string& component, const std::string& leader,
                                    Patience patience) {
  const auto done = Retry(
      patience, [&](SteadyTime deadline) { return TryRunAfter(component, leader, deadline); });
  if (done) NotifyChanged();
  return done;
}

Result<void> LocalManager::TryRunAfter(const std::string& component, const std::string& leader,
                                       SteadyTime deadline) {
  const auto follower = Require(component);
  if (!follower) return follower.error();
  const auto first = Require(leader);
  if (!first) return first.error();
  auto* task = dynamic_cast<ThreadedTask*>(follower->get());
  auto* leading = dynamic_cast<Task*>(first->get());
  if (task == nullptr || leading == nullptr) {
    return Error{ErrorCode::kFailed, "component '" + component + "' cannot run after '" + leader +
                                         "': '" +
                                         (task == nullptr ? component + "' has no thread"
                                                          : leader + "' does not run in cycles")};
  }
  if (serializer_.IsInUse(*task)) return RequestInProgress(component);
  return task->RunAfter(*leading, deadline);
}

Result<void> LocalManager::Start(const std::string& component, Patience patience) {
  return RequestState(component, &tendon::Start, ComponentState::kActive, patience);
}

Result<void> LocalManager::Start(const std::string& component, Patience patience,
                                 std::function<bool()> proceed) {
  const auto start = [proceed = std::move(proceed)](Component& one) {
    return one.Start(kNoWait, proceed);
  };
  return RequestState(component, start, ComponentState::kActive, patience);
}

Result<void> LocalManager::Suspend(const std::string& component, Patience patience) {
  return RequestState(component, &tendon::Suspend, ComponentState::kSuspended, patience);
}

Result<void> LocalManager::Stop(const std::string& component, Patience patience) {
  if (patience <= kNoWait) {
    return RequestState(component, &tendon::Stop, ComponentState::kFinished, patience);
  }
  const auto found = Require(component);
  if (!found) return found.error();
  const SteadyTime deadline = DeadlineAfter(patience);
  (void)StopInOrder([&](const Component& one) { return RunsAfter(one, **found); }, deadline);
  const Patience left =
      std::max<Patience>(RequestSerializer::kShortest, deadline - SteadyClock().Now());
  const auto stopped = RequestStateOfAll({*found}, &tendon::Stop, ComponentState::kFinished, left);
  if (stopped) {
    LetExecute(**found, std::min<SteadyTime>(deadline, SteadyClock().Now() + kDrainPatience));
  }
  return stopped;
}

Result<void> LocalManager::TransitionTo(const std::string& component, ComponentState wanted,
                                        Patience patience) {
  if (!IsRunning(wanted)) return {};
  auto done = Start(component, patience);
  if (wanted == ComponentState::kActive) return done;
  const auto is_at_rest = [&] {
    const auto settings = SettingsOf(component);
    return !settings || settings->is_at_rest;
  };
  if (done) done = Suspend(component, patience);
  if (done || is_at_rest()) return done;
  const auto stopped = Stop(component, kPatience);
  const std::string before = "'" + component + "' could not be suspended: " + done.error().message;
  if (stopped || is_at_rest()) {
    return Error{done.error().code, before + "; it was stopped instead"};
  }
  return Error{done.error().code,
               before + "; it may still run, because it does not stop: " + stopped.error().message};
}

Result<void> LocalManager::StartAll(Patience patience) {
  Components all = InOrder();
  std::erase_if(all, [](const auto& one) { return one->state() == ComponentState::kActive; });
  return RequestStateOfAll(all, &tendon::Start, ComponentState::kActive, patience);
}

Result<void> LocalManager::SuspendAll(Patience patience) {
  Components all = InOrder();
  std::reverse(all.begin(), all.end());
  std::erase_if(all, [](const auto& one) { return one->state() != ComponentState::kActive; });
  return RequestStateOfAll(all, &tendon::Suspend, ComponentState::kSuspended, patience);
}

Result<void> LocalManager::StopAll(Patience patience) {
  const auto any = [](const Component& /*one*/) { return true; };
  if (patience > kNoWait) return StopInOrder(any, DeadlineAfter(patience));
  Components all;
  for (OrderlyShutdown::Member& one : InEndOrder(any)) all.push_back(std::move(one.component));
  std::erase_if(all, [this](const auto& one) { return IsAtRest(*one); });
  return RequestStateOfAll(all, &tendon::Stop, ComponentState::kFinished, patience);
}

void LocalManager::EndAll(SteadyTime deadline) {
  const auto ended = StopInOrder([](const Component& /*one*/) { return true; }, deadline);
  if (ended) return;
  Log(LogLevel::kWarning, "manager", "the shutdown is not complete: " + ended.error().message);
}

Result<void> LocalManager::StopInOrder(const IsMeant& is_meant, SteadyTime deadline) {
  const auto stop = [this](const std::shared_ptr<Component>& one) {
    return MakeRequest(one, &tendon::Stop, SteadyClock().Now());
  };
  OrderlyShutdown end(
      InEndOrder(is_meant),
      {.is_at_rest = [this](const Component& one) { return IsAtRest(one); },
       .stop = stop,
       .has_calls_under_way = [this](const Component& one) { return HasCallsUnderWay(one); }});
  return end.Run(deadline);
}

/// Returns true if the component is at rest and no request for it is in progress. A request in
/// progress might start the component.
bool LocalManager::IsAtRest(const Component& component) const {
  const auto lock = Lock();
  return component.is_at_rest() && !serializer_.IsInUse(component);
}

void LocalManager::LetExecute(const Component& client, SteadyTime deadline) const {
  constexpr std::chrono::microseconds kBetweenLooks(500);
  while (HasCallsUnderWay(client)) {
    if (SteadyClock().Now() >= deadline) return OrderlyShutdown::LogNotExecuted(client);
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

/// Ignores servers whose calls this thread executes, because they execute nothing while this thread
/// waits.
bool LocalManager::HasCallsUnderWay(const Component& client) const {
  const auto lock = Lock();
  return std::ranges::any_of(connections_, [&](const auto& one) {
    const ConnectionDescription& ends = one.second.description;
    if (ends.required.component != client.name()) return false;
    if (one.second.connection->waiting() == 0) return false;
    const auto server = FindProvided(ends.provided);
    const Inbox* const inbox = server ? (*server)->inbox() : nullptr;
    return inbox != nullptr && inbox->accepting() && inbox->IsForeignThread();
  });
}

ComponentOrder LocalManager::Order() const {
  Components components;
  for (const Entry& entry : entries_) components.push_back(entry.component);
  ComponentOrder order(std::move(components));
  for (const auto& [id, connection] : connections_) {
    const ConnectionDescription& ends = connection.description;
    order.AddConnection(ends.required.component, ends.provided.component);
  }
  return order;
}

LocalManager::Components LocalManager::InOrder() const {
  const auto lock = Lock();
  return Order().StartOrder();
}

std::vector<OrderlyShutdown::Member> LocalManager::InEndOrder(const IsMeant& is_meant) const {
  const auto lock = Lock();
  return Order().EndOrder(is_meant);
}

Result<void> LocalManager::WaitFor(const std::string& component, ComponentState state,
                                   Patience patience) {
  const auto found = Require(component);
  return found ? (*found)->WaitFor(state, patience) : found.error();
}

Result<void> LocalManager::WaitForAll(ComponentState state, Patience patience) {
  const SteadyTime deadline = DeadlineAfter(patience);
  for (const auto& one : InOrder()) {
    const auto reached = one->WaitFor(state, std::max(kNoWait, deadline - SteadyClock().Now()));
    if (!reached) return reached;
  }
  return {};
}

Result<void> LocalManager::RequestState(const std::string& component, const Request& request,
                                        ComponentState wanted, Patience patience) {
  const auto found = Require(component);
  return found ? RequestStateOfAll({*found}, request, wanted, patience) : found.error();
}

Result<void> LocalManager::RequestStateOfAll(const Components& components, const Request& request,
                                             ComponentState wanted, Patience patience) {
  const SteadyTime deadline = DeadlineAfter(patience);
  Result<void> outcome;
  for (const auto& one : components) {
    Result<void> done = MakeRequest(one, request, deadline);
    if (done && patience > kNoWait) {
      done = one->WaitForEffect(wanted, std::max(kNoWait, deadline - SteadyClock().Now()));
    }
    if (!done && outcome) outcome = done;
  }
  return outcome;
}

Result<void> LocalManager::MakeRequest(const std::shared_ptr<Component>& component,
                                       const Request& request, SteadyTime deadline) {
  auto lock = Lock();
  const RequestSerializer::Turn turn(serializer_, *component, lock, deadline);
  if (!turn.is_ours()) return RequestInProgress(component->name());
  if (Find(component->name()) != component.get()) {
    return Error{ErrorCode::kNotFound,
                 "component '" + component->name() + "' was removed by another request"};
  }
  return WithoutLock(lock, [&] { return request(*component); });
}

Error LocalManager::RequestInProgress(const std::string& component) {
  return {ErrorCode::kTimeout, "component '" + component +
                                   "' is still busy with an earlier request; it may be in "
                                   "its Configure(), Startup() or Cleanup()"};
}

}  // namespace tendon
