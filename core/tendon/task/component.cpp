#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/task/component.h>

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

std::string Quoted(const std::string& name) { return "'" + name + "'"; }

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
}

Result<void> Component::Start() {
  const ComponentState before = state();
  if (before == ComponentState::kActive || before == ComponentState::kSuspended) {
    return Error{ErrorCode::kFailed, "component " + Quoted(name_) + " is " +
                                         std::string(ToString(before)) + "; stop it first"};
  }
  if (before == ComponentState::kConstructed || before == ComponentState::kFaulted) {
    {
      const std::scoped_lock lock(mutex_);
      fault_.clear();
    }
    if (!RunGuarded("Configure", [this] { Configure(); })) {
      return Error{ErrorCode::kFailed, "component " + Quoted(name_) + " did not start: " + fault()};
    }
    SetState(ComponentState::kReady);
  }
  return Launch();
}

Result<void> Component::Stop() {
  if (state() == ComponentState::kFaulted) {
    Halt();  // joins the thread that has ended
    return {};
  }
  if (state() != ComponentState::kActive) {
    return Error{ErrorCode::kFailed, "component " + Quoted(name_) + " is " +
                                         std::string(ToString(state())) + ", not active"};
  }
  Halt();
  return {};
}

void Component::SetStateObserver(std::function<void()> observer) {
  const std::scoped_lock lock(mutex_);
  observer_ = std::move(observer);
}

ProvidedInterface& Component::AddProvidedInterface(std::string name) {
  if (IsReserved(name)) {
    throw ConfigurationError("interface " + Quoted(name) + " of " + Quoted(name_) +
                             ": the names state and state-... belong to state tables");
  }
  return AddReservedInterface(std::move(name));
}

ProvidedInterface& Component::AddReservedInterface(std::string name) {
  CheckNew("provided interface", name);
  provided_.push_back(std::make_unique<ProvidedInterface>(std::move(name), inbox_.get()));
  return *provided_.back();
}

RequiredInterface& Component::AddRequiredInterface(std::string name, Need need) {
  CheckNew("required interface", name);
  required_.push_back(std::make_unique<RequiredInterface>(std::move(name), inbox_.get(), need));
  return *required_.back();
}

Result<void> Component::Launch() {
  if (!RunGuarded("Startup", [this] { Startup(); })) {
    return Error{ErrorCode::kFailed, "component " + Quoted(name_) + " did not start: " + fault()};
  }
  SetState(ComponentState::kActive);
  return {};
}

void Component::Halt() {
  if (state() != ComponentState::kActive) return;
  if (RunGuarded("Cleanup", [this] { Cleanup(); })) SetState(ComponentState::kFinished);
}

void Component::EnterFault(const char* where, const std::string& reason) {
  {
    const std::scoped_lock lock(mutex_);
    fault_ = std::string(where) + ": " + reason;
  }
  Log(LogLevel::kError, name_, "faulted in " + std::string(where) + ": " + reason);
  SetState(ComponentState::kFaulted);
}

void Component::SetState(ComponentState state) {
  if (inbox_) inbox_->SetAccepting(state == ComponentState::kActive);
  state_.Set(state);
  std::function<void()> observer;
  {
    const std::scoped_lock lock(mutex_);
    observer = observer_;
  }
  if (observer) observer();
}

void Component::CheckNew(const std::string& what, const std::string& name) const {
  RequireName(what, name);
  if (sealed_) {
    throw ConfigurationError("cannot add " + what + " " + Quoted(name) + " to component " +
                             Quoted(name_) + " (state " + std::string(ToString(state())) +
                             "): add it in the constructor");
  }
  if (FindProvided(name) != nullptr || FindRequired(name) != nullptr) {
    throw ConfigurationError("interface " + Quoted(name) + " already exists in " + Quoted(name_));
  }
}

}  // namespace tendon
