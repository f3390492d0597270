#include <tendon/task/component.h>

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/interface/execution/block_when_full.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

template <typename List>
auto FindByName(const List& list, const std::string& name) -> decltype(list.front().get()) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&name](const auto& one) { return one->name() == name; });
  return found == list.end() ? nullptr : found->get();
}

bool IsReserved(const std::string& name) { return name == "state" || name.starts_with("state-"); }

/// Returns the transition for a request, or an error that says why the request is refused. `mutex`
/// guards state changes.
Result<const Transition*> Lookup(const Component& component, std::mutex& mutex,
                                 LifecycleRequest request) {
  const std::scoped_lock lock(mutex);  // the state and the flag change together
  if (request == LifecycleRequest::kStop && (component.is_starting() || component.is_stopping())) {
    return &TransitionOf(ComponentState::kActive, request);
  }
  if (component.is_stopping()) {
    return Error{ErrorCode::kFailed, "component " + Quoted(component.name()) +
                                         " is still stopping; wait until it is finished"};
  }
  if (component.is_starting()) {
    return Error{ErrorCode::kFailed, "component " + Quoted(component.name()) +
                                         " is still starting; wait until it is active, or stop it"};
  }
  const Transition& transition = TransitionOf(component.state(), request);
  if (transition.refusal.empty()) return &transition;
  return Error{ErrorCode::kFailed, "component " + Quoted(component.name()) + " is " +
                                       std::string(ToString(transition.from)) +
                                       std::string(transition.refusal)};
}

void RequireNew(const std::string& what, const LocatedName& name, const Component& component,
                bool is_sealed, std::map<std::string, SourceLocation>& added_at) {
  RequireName(what, name.text);
  if (is_sealed) {
    throw AddedTooLate(what + " " + Quoted(name.text), "component " + Quoted(component.name()),
                       "state " + std::string(ToString(component.state())));
  }
  const auto [first, is_new] = added_at.emplace(name.text, name.location);
  if (!is_new) {
    throw ConfigurationError("interface " + Quoted(name.text) + " already exists in " +
                             Quoted(component.name()) + " (added at " + ToString(first->second) +
                             ")");
  }
}

}  // namespace

Component::Component(std::string name) : Component(std::move(name), nullptr) {}

Component::Component(std::string name, std::unique_ptr<Inbox> inbox)
    : name_(std::move(name)), inbox_(std::move(inbox)) {
  RequireName("component", name_);
}

Component::~Component() = default;

std::string Component::fault() const {
  const std::scoped_lock lock(mutex_);
  return fault_;
}

std::chrono::system_clock::time_point Component::fault_time() const {
  const std::scoped_lock lock(mutex_);
  return fault_time_;
}

ProvidedInterface* Component::FindProvided(const std::string& name) const {
  return FindByName(provided_, name);
}

RequiredInterface* Component::FindRequired(const std::string& name) const {
  return FindByName(required_, name);
}

std::vector<ProvidedDescription> Component::provided() const {
  std::vector<ProvidedDescription> all;
  for (const auto& one : provided_) all.push_back(one->description());
  return all;
}

std::vector<RequiredDescription> Component::required() const {
  std::vector<RequiredDescription> all;
  for (const auto& one : required_) all.push_back(one->description());
  return all;
}

void Component::Seal() {
  sealed_ = true;
  for (const auto& one : provided_) one->Seal();
  for (const auto& one : required_) one->Seal();
  for (const auto& one : provided_) {
    const auto own = one->expiries();
    expiries_.insert(expiries_.end(), own.begin(), own.end());
  }
  if (expiries_.empty() || inbox_) return;
  throw ConfigurationError("command '" + expiries_.front()->command() + "' of " + Quoted(name_) +
                           " cannot expire, because a component without a thread cannot end the "
                           "action of the command. Derive the component from a task");
}

Result<void> Component::Start(std::chrono::nanoseconds timeout,
                              const std::function<bool()>& proceed) {
  const auto transition = Lookup(*this, mutex_, LifecycleRequest::kStart);
  if (!transition) return transition.error();
  const Error stopped{ErrorCode::kFailed, "component " + Quoted(name_) +
                                              " is not started, because a stop was requested"};
  if (proceed && !proceed()) return stopped;
  if ((*transition)->from == ComponentState::kSuspended) {
    const auto resumed = Resume();
    return resumed && timeout > kNoWait ? WaitForEffect(ComponentState::kActive, timeout) : resumed;
  }
  if ((*transition)->configures_first) {
    if (!RunGuarded("Configure", [this] { Configure(); })) {
      return WaitFor(ComponentState::kReady, kNoWait);  // fails, with the reason
    }
    {
      const std::scoped_lock lock(mutex_);
      fault_.clear();
      fault_time_ = {};
    }
    SetState(ComponentState::kReady);
    if (proceed && !proceed()) return stopped;
  }
  is_starting_.Set(true);
  if (const auto launched = Launch(); !launched) {
    is_starting_.Set(false);
    return launched;
  }
  return timeout > kNoWait ? WaitForEffect(ComponentState::kActive, timeout) : Result<void>();
}

Result<void> Component::Suspend(std::chrono::nanoseconds timeout) {
  const auto transition = Lookup(*this, mutex_, LifecycleRequest::kSuspend);
  if (!transition) return transition.error();
  Pause();
  return timeout > kNoWait ? WaitForEffect(ComponentState::kSuspended, timeout) : Result<void>();
}

Result<void> Component::Stop(std::chrono::nanoseconds timeout) {
  const auto transition = Lookup(*this, mutex_, LifecycleRequest::kStop);
  if (!transition) return transition.error();
  {
    const std::scoped_lock lock(mutex_);  // the state may just have changed
    is_stopping_.Set(is_starting() || IsRunning(state()));
  }
  Halt();
  return timeout > kNoWait ? WaitForEffect(ComponentState::kFinished, timeout) : Result<void>();
}

Result<void> Component::WaitFor(ComponentState wanted, std::chrono::nanoseconds timeout) {
  return WaitForState(wanted, timeout, false);
}

Result<void> Component::WaitForEffect(ComponentState wanted, std::chrono::nanoseconds timeout) {
  return WaitForState(wanted, timeout, true);
}

Result<void> Component::WaitForState(ComponentState wanted, std::chrono::nanoseconds timeout,
                                     bool ends_with_a_stop) {
  constexpr std::chrono::milliseconds kBetweenLooks(10);
  const SteadyTime deadline = DeadlineAfter(timeout);
  std::unique_lock lock(mutex_);
  while (state() != wanted) {
    const std::string who = "component " + Quoted(name_) + " is ";
    if (state() == ComponentState::kFaulted) {
      return Error{ErrorCode::kFailed, who + "faulted: " + fault_};
    }
    if (ends_with_a_stop && state() == ComponentState::kFinished && !is_starting()) {
      return Error{ErrorCode::kFailed,
                   who + "not " + std::string(ToString(wanted)) + ", because it was stopped"};
    }
    const SteadyTime now = SteadyClock().Now();
    if (now >= deadline) {
      const auto waited = std::chrono::ceil<std::chrono::milliseconds>(timeout).count();
      return Error{ErrorCode::kTimeout, who + "still " + std::string(ToString(state())) +
                                            " after " + std::to_string(waited) + " ms, not " +
                                            std::string(ToString(wanted)) +
                                            "; it may be busy in one of its own functions"};
    }
    lock.unlock();
    ServeWaiting();
    lock.lock();
    if (state() == wanted) break;
    changed_.wait_until(lock, std::min<SteadyTime>(deadline, now + kBetweenLooks));
  }
  return {};
}

bool Component::is_at_rest() const {
  const std::scoped_lock lock(mutex_);  // the state and the flag change together
  return !is_starting() && !IsRunning(state());
}

void Component::End() {
  bool was_asked = false;
  bool was_said = false;
  while (!is_at_rest()) {
    if (!is_starting() && !std::exchange(was_asked, true)) Halt();
    const auto ended = WaitFor(ComponentState::kFinished, std::chrono::seconds(1));
    if (ended || is_at_rest() || std::exchange(was_said, true)) continue;
    Log(LogLevel::kWarning, name_, "cannot be destroyed yet: " + ended.error().message);
  }
}

Inbox::Fill Component::mailbox_fill() const { return inbox_ ? inbox_->fill() : Inbox::Fill(); }

void Component::SetStateObserver(std::function<void()> observer) {
  const std::scoped_lock lock(mutex_);
  observer_ = std::move(observer);
}

ProvidedInterface& Component::AddProvidedInterface(LocatedName name) {
  if (IsReserved(name.text)) {
    throw ConfigurationError("interface " + Quoted(name.text) + " of " + Quoted(name_) +
                             ": the names state and state-... belong to state tables");
  }
  return AddReservedInterface(std::move(name));
}

ProvidedInterface& Component::AddReservedInterface(LocatedName name) {
  RequireNew("provided interface", name, *this, sealed_, added_at_);
  // The interface of a state table is not bound to the state of the component. Therefore, the table
  // can also be read while the component is faulted, when its rows are most important.
  const ComponentAccess* const access = IsReserved(name.text) ? nullptr : &access_;
  provided_.push_back(
      std::make_unique<ProvidedInterface>(std::move(name.text), inbox_.get(), access));
  return *provided_.back();
}

RequiredInterface& Component::AddRequiredInterface(LocatedName name, Need need) {
  RequireNew("required interface", name, *this, sealed_, added_at_);
  required_.push_back(
      std::make_unique<RequiredInterface>(std::move(name.text), inbox_.get(), need, &access_));
  return *required_.back();
}

Result<void> Component::Launch() {
  if (RunGuarded("Startup", [this] { Startup(); })) SetState(ComponentState::kActive);
  return {};
}

void Component::Pause() { SetState(ComponentState::kSuspended); }

Result<void> Component::Resume() {
  if (ReportResume()) SetState(ComponentState::kActive);
  return {};
}

void Component::Halt() {
  access_.SetAccepting(false);  // before Cleanup() frees data that calls use
  const BlockWhenFull get_through;
  if (RunGuarded("Cleanup", [this] { Cleanup(); })) SetState(ComponentState::kFinished);
}

bool Component::ReportPeers(RequiredInterface& interface) {
  using Change = RequiredInterface::PeerChange;
  const bool is_notified_first = interface.callers() == CallerThreads::kManyThreads;
  while (true) {
    const Change change = interface.peer_change();
    if (change == Change::kNone) return true;
    if (change == Change::kGone) {
      interface.ForgetPeer();
      if (!RunGuarded("OnDisconnected", [&] { OnDisconnected(interface); })) return false;
      continue;
    }
    if (!interface.TakePeer()) return true;
    if (!is_notified_first) interface.AdmitPeer();
    if (!RunGuarded("OnConnected", [&] { OnConnected(interface); })) {
      if (inbox_) interface.ForgetPeer();  // so OnConnected() runs again at the next start
      return false;
    }
    // If the component has no thread, the caller of this function calls AdmitPeer().
    if (is_notified_first && inbox_) interface.AdmitPeer();
  }
}

bool Component::ReportGoneClient(const DisconnectedClient& client) {
  return RunGuarded("OnClientGone", [&] {
    for (Expiry* const expiry : expiries_) {
      if (expiry->IsOf(client.connection)) expiry->End();
    }
    OnClientGone(*client.provided, client.name);
  });
}

bool Component::ReportConnections() {
  for (const auto& one : required_) {
    // If the component has no thread, the threads that change its connections call ReportPeers().
    if (inbox_ && !ReportPeers(*one)) return false;
  }
  bool is_good = true;
  gone_clients_.Take(
      [&](const DisconnectedClient& client) { is_good = is_good && ReportGoneClient(client); });
  return is_good;
}

bool Component::ReportBeforeStartup() {
  for (Expiry* const expiry : expiries_) expiry->Disarm();
  gone_clients_.Take([](const DisconnectedClient& /*client*/) {});
  return ReportConnections();
}

bool Component::ReportResume() {
  return ReportConnections() && RunGuarded("OnResume", [this] {
           EndExpired(SteadyClock().Now());
           OnResume();
         });
}

void Component::EndExpired(SteadyTime now) {
  for (Expiry* const expiry : expiries_) {
    if (expiry->due() > now) continue;
    Log(LogLevel::kInfo, name_, expiry->message());
    expiry->End();
  }
}

SteadyTime Component::next_expiry() const noexcept {
  SteadyTime next = SteadyTime::max();
  for (const Expiry* const expiry : expiries_) next = std::min(next, expiry->due());
  return next;
}

void Component::DeliverPeerChange(RequiredInterface& interface) { (void)ReportPeers(interface); }

void Component::DeliverDisconnectedClient(DisconnectedClient client) {
  if (!is_at_rest()) (void)ReportGoneClient(client);
}

void Component::QueueGoneClient(DisconnectedClient client) {
  if (is_at_rest()) return;
  const auto is_same = [&client](const DisconnectedClient& one) {
    return one.provided == client.provided && one.name == client.name;
  };
  // A suspended component gets only one report for a client that connects and disconnects several
  // times.
  if (state() == ComponentState::kSuspended && gone_clients_.HasUnread(is_same)) return;
  gone_clients_.Send(std::move(client));
}

void Component::EnterFault(const char* where, const std::string& reason) {
  {
    const std::scoped_lock lock(mutex_);
    fault_ = std::string(where) + ": " + reason;
    fault_time_ = std::chrono::system_clock::now();
  }
  Log(LogLevel::kError, name_, "faulted in " + std::string(where) + ": " + reason);
  SetState(ComponentState::kFaulted);
}

void Component::FaultFromOutside(const std::string& reason) {
  if (IsRunning(state())) return EnterFault(kInHandler, reason);
  Log(LogLevel::kError, name_, std::string(kInHandler) + " has failed: " + reason);
}

void Component::SetState(ComponentState state) {
  const bool is_faulted = state == ComponentState::kFaulted;
  if (inbox_) {
    inbox_->SetAccepting(state == ComponentState::kActive);
    if (!IsRunning(state)) inbox_->Unbind();
  }
  if (is_faulted != access_.is_faulted() && (is_faulted || state == ComponentState::kReady)) {
    access_.SetFaulted(is_faulted);
    for (const auto& one : provided_) one->SetSourceFaulted(is_faulted);
  }
  std::function<void()> observer;
  {
    const std::scoped_lock lock(mutex_);
    is_starting_.Set(false);
    if (!IsRunning(state)) is_stopping_.Set(false);
    // Another thread may have faulted the component at the same time. Then it stays faulted until
    // the next start.
    if (access_.is_faulted()) state = ComponentState::kFaulted;
    access_.SetAccepting(state == ComponentState::kActive);
    state_.Set(state);
    observer = observer_;
  }
  changed_.notify_all();
  if (observer) observer();
}

}  // namespace tendon
