#include <tendon/process/lifecycle/lifecycle_executor.h>

#include <tendon/base/log.h>
#include <tendon/manager/unsatisfied_interface.h>
#include <tendon/payload/json.h>
#include <tendon/process/lifecycle/configuration_base.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using message::LifecycleOrder;

constexpr std::chrono::nanoseconds kLongestTimeout = std::chrono::hours(1);

/// Returns the time until the deadline, but at least 1 ms, because kNoWait would report success
/// before the change has happened.
std::chrono::nanoseconds Left(SteadyTime deadline) {
  return std::max<std::chrono::nanoseconds>(std::chrono::milliseconds(1),
                                            deadline - SteadyClock().Now());
}

std::string WordsFor(const LifecycleOrder& order) {
  const std::string& object = order.component.empty() ? order.library : order.component;
  return std::string(ToString(order.verb)) + " '" + object + "'";
}

/// Returns the outcome of an order for a component that existed before.
message::LifecycleOutcome OutcomeAfter(const ComponentDescription& before) {
  return {.state = before.state, .class_name = before.class_name, .library = before.library};
}

bool IsAmong(const std::vector<ConnectionDescription>& all, const ConnectionDescription& wanted) {
  return std::ranges::any_of(all, [&wanted](const ConnectionDescription& one) {
    return one.required == wanted.required && one.provided == wanted.provided;
  });
}

}  // namespace

/// Reserves a component for one order. Tells this order whether a stop has arrived.
class LifecycleExecutor::Claim {
 public:
  Claim(LifecycleExecutor& executor, std::string component)
      : executor_(executor), component_(std::move(component)) {
    const std::scoped_lock lock(executor_.claims_mutex_);
    is_ours_ = executor_.claims_.emplace(component_, false).second;
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  ~Claim() {
    const std::scoped_lock lock(executor_.claims_mutex_);
    if (is_ours_) executor_.claims_.erase(component_);
  }

  [[nodiscard]] Result<void> Check() const {
    if (is_ours_) return {};
    return Error{ErrorCode::kFailed,
                 "component '" + component_ +
                     "' must execute another order first: nothing was done; try "
                     "again when that order is done"};
  }
  [[nodiscard]] bool is_to_stop() const {
    const std::scoped_lock lock(executor_.claims_mutex_);
    return executor_.is_ending_ || executor_.claims_.at(component_);
  }

 private:
  LifecycleExecutor& executor_;
  const std::string component_;
  bool is_ours_ = false;
};

void LifecycleExecutor::ExecuteOrder(const LifecycleOrder& order, Begin begin,
                                     Done<message::LifecycleOutcome> done) {
  const std::chrono::nanoseconds timeout = std::clamp(order.timeout, kNoWait, kLongestTimeout);
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  ThreadPerTask& threads = order.verb == LifecycleVerb::kStop ? stops_ : orders_;
  const auto begun = threads.Do([this, order, begin = std::move(begin), done, deadline] {
    const Outcome outcome = ExecuteGuarded({order, deadline, begin});
    const std::string words = "ordered remotely: " + WordsFor(order);
    if (outcome) {
      Log(LogLevel::kInfo, parts_.process, words);
    } else {
      Log(LogLevel::kWarning, parts_.process, words + ": " + outcome.error().message);
    }
    done(outcome);
  });
  if (!begun) done(begun.error());
}

void LifecycleExecutor::ListClasses(Done<message::Classes> done) {
  const auto begun = class_queries_.Do([this, done] { done(factory_.classes()); });
  if (!begun) done(begun.error());
}

void LifecycleExecutor::WatchPlugins(std::function<void()> changed) {
  if (const auto files = factory_.files()) {
    watch_ = std::make_unique<PluginWatch>(files, std::move(changed));
  }
}

std::vector<PluginDescription> LifecycleExecutor::plugins() const {
  const auto files = factory_.files();
  return files ? files->descriptions() : std::vector<PluginDescription>();
}

void LifecycleExecutor::Close() {
  for (ThreadPerTask* const threads : {&orders_, &stops_, &class_queries_}) threads->Close();
  const std::scoped_lock lock(claims_mutex_);
  is_ending_ = true;
}

void LifecycleExecutor::Stop() {
  constexpr std::chrono::milliseconds kBetweenStops(100);
  watch_.reset();
  Close();
  while (!orders_.WaitUntilIdle(std::chrono::milliseconds(0))) {
    (void)parts_.manager.StopAll(kNoWait);
    (void)orders_.WaitUntilIdle(kBetweenStops);
  }
  for (ThreadPerTask* const threads : {&orders_, &stops_, &class_queries_}) threads->Stop();
}

/// Executes an order. Catches all exceptions, because a plug-in may throw anything.
LifecycleExecutor::Outcome LifecycleExecutor::ExecuteGuarded(const TimedOrder& given) {
  try {
    return Execute(given);
  } catch (...) {
    return Error{ErrorCode::kFailed,
                 WordsFor(given.order) + ": " + ReasonOf(std::current_exception())};
  }
}

LifecycleExecutor::Outcome LifecycleExecutor::Execute(const TimedOrder& given) {
  const LifecycleOrder& order = given.order;
  if (order.verb == LifecycleVerb::kLoad) return Load(given);
  if (order.verb == LifecycleVerb::kStop) return StopComponent(given);
  const Claim claim(*this, order.component);
  if (auto checked = claim.Check(); !checked) return checked.error();
  switch (order.verb) {
    case LifecycleVerb::kCreate:
      return Create(given);
    case LifecycleVerb::kConfigure:
      return Configure(given);
    case LifecycleVerb::kStart:
    case LifecycleVerb::kSuspend:
      return StartOrSuspend(given, claim);
    case LifecycleVerb::kRestart:
      return Restart(given, claim);
    case LifecycleVerb::kRemove:
      return Remove(given);
    default:
      return Error{ErrorCode::kInvalid,
                   "this LCM does not know this order, because this LCM is older than its GCM"};
  }
}

Result<void> LifecycleExecutor::MarkBegun(const TimedOrder& given) const {
  if (SteadyClock().Now() > given.deadline) {
    return Error{ErrorCode::kFailed,
                 "process '" + parts_.process +
                     "' was busy with other orders until the time limit of this order "
                     "had passed: nothing was done; try again"};
  }
  auto begun = given.begin();
  if (begun) return begun;
  return Error{begun.error().code, "nothing was done: " + begun.error().message};
}

LifecycleExecutor::Outcome LifecycleExecutor::Load(const TimedOrder& given) {
  const auto loaded = factory_.Load(given.order.library, [&] { return MarkBegun(given); });
  if (!loaded) return loaded.error();
  return message::LifecycleOutcome{};
}

LifecycleExecutor::Outcome LifecycleExecutor::Create(const TimedOrder& given) {
  const LifecycleOrder& order = given.order;
  if (auto checked = CheckName("component", order.component); !checked) return checked.error();
  if (parts_.manager.Find(order.component) != nullptr) {
    return Error{ErrorCode::kExists, "component '" + order.component +
                                         "' already exists in process '" + parts_.process +
                                         "'; choose another name, or remove it first"};
  }
  auto made = factory_.Make(order, [&] { return MarkBegun(given); });
  if (!made) return made.error();
  message::LifecycleOutcome outcome{.class_name = made->origin.class_name,
                                    .library = made->origin.library,
                                    .configuration = made->origin.configuration};
  if (auto added = Add(*std::move(made)); !added) return added.error();
  if (order.leader.empty()) return outcome;
  const auto follows = parts_.manager.RunAfter(order.component, order.leader, Left(given.deadline));
  if (follows) return outcome;
  (void)parts_.manager.Remove(order.component, Left(given.deadline));
  return follows.error();
}

/// Creates the new component first, so that the old one stays unchanged if this fails.
LifecycleExecutor::Outcome LifecycleExecutor::Configure(const TimedOrder& given) {
  const std::string& component = given.order.component;
  const auto before = FindOfClass(component, "configured again");
  if (!before) return before.error();
  if (auto checked = CheckBase(given.order, before->configuration); !checked) {
    return checked.error();
  }
  const auto settings = parts_.manager.SettingsOf(component);
  if (!settings) return settings.error();
  if (!settings->is_at_rest) {
    const bool is_running = IsRunning(before->state);
    return Error{ErrorCode::kFailed,
                 "component '" + component + "' is " +
                     (is_running ? std::string(ToString(before->state)) : "starting") +
                     "; stop it first to configure it again"};
  }
  LifecycleOrder create = given.order;
  create.class_name = before->class_name;
  create.library = before->library;
  create.thread = settings->thread ? ToJson(*settings->thread) : "";
  auto made = factory_.Make(create, [&] { return MarkBegun(given); });
  if (!made) return made.error();
  message::LifecycleOutcome outcome = OutcomeAfter(*before);
  outcome.former = before->configuration;
  outcome.configuration = made->origin.configuration;
  const auto connections = ConnectionsOf(component);
  if (auto replaced = parts_.manager.Replace(std::move(made->component), std::move(made->origin),
                                             Left(given.deadline));
      !replaced) {
    return replaced.error();
  }
  if (const auto whole = Reconnect(connections); !whole) outcome.warning = whole.error().message;
  return outcome;
}

LifecycleExecutor::Outcome LifecycleExecutor::StartOrSuspend(const TimedOrder& given,
                                                             const Claim& claim) {
  const std::string& component = given.order.component;
  const auto before = Find(component);
  if (!before) return before.error();
  if (given.order.is_strict) {
    const auto needs = UnmetNeedsOf(*before, parts_.manager.connections());
    if (auto checked = CheckNeeds(component, needs); !checked) return checked.error();
  }
  if (auto begun = MarkBegun(given); !begun) return begun.error();
  const auto changed = given.order.verb == LifecycleVerb::kStart
                           ? StartUnlessStopped(given, claim)
                           : parts_.manager.Suspend(component, Left(given.deadline));
  if (!changed) return changed.error();
  return OutcomeAfter(*before);
}

/// Stops a component, without waiting for claims. If the GCM is slow or absent, does not wait for
/// its confirmation either. If the stop interrupts another order, first marks the claim of that
/// order.
LifecycleExecutor::Outcome LifecycleExecutor::StopComponent(const TimedOrder& given) {
  const std::string& component = given.order.component;
  const auto before = Find(component);
  if (!before) return before.error();
  {
    const std::scoped_lock lock(claims_mutex_);
    const auto claim = claims_.find(component);
    if (claim != claims_.end()) claim->second = true;
  }
  const auto begun = MarkBegun(given);
  const bool is_void = !begun && begun.error().code == ErrorCode::kFailed;
  if (is_void) return begun.error();
  const auto stopped = parts_.manager.Stop(component, Left(given.deadline));
  if (!stopped) return stopped.error();
  return OutcomeAfter(*before);
}

LifecycleExecutor::Outcome LifecycleExecutor::Restart(const TimedOrder& given, const Claim& claim) {
  const std::string& component = given.order.component;
  const auto before = Find(component);
  if (!before) return before.error();
  if (auto begun = MarkBegun(given); !begun) return begun.error();
  if (IsRunning(before->state)) {
    if (auto stopped = parts_.manager.Stop(component, Left(given.deadline)); !stopped) {
      return stopped.error();
    }
  }
  if (auto started = StartUnlessStopped(given, claim); !started) return started.error();
  return OutcomeAfter(*before);
}

/// Starts the component, unless a stop has arrived. A stop that arrived earlier is marked in the
/// claim. A stop that arrives later finds a component that is starting, and stops it.
Result<void> LifecycleExecutor::StartUnlessStopped(const TimedOrder& given, const Claim& claim) {
  return parts_.manager.Start(given.order.component, Left(given.deadline),
                              [&claim] { return !claim.is_to_stop(); });
}

LifecycleExecutor::Outcome LifecycleExecutor::Remove(const TimedOrder& given) {
  const std::string& component = given.order.component;
  const auto before = FindOfClass(component, "removed");
  if (!before) return before.error();
  const auto settings = parts_.manager.SettingsOf(component);
  if (!settings) return settings.error();
  if (auto begun = MarkBegun(given); !begun) return begun.error();
  if (auto removed = RemoveFromProcess(component, given.deadline); !removed) return removed.error();
  message::LifecycleOutcome outcome = OutcomeAfter(*before);
  outcome.former = before->configuration;
  outcome.thread = settings->thread ? ToJson(*settings->thread) : "";
  outcome.leader = settings->leader;
  return outcome;
}

/// Stops and removes a component. If the component cannot be removed, makes its connections again.
Result<void> LifecycleExecutor::RemoveFromProcess(const std::string& component,
                                                  SteadyTime deadline) {
  const auto connections = ConnectionsOf(component);
  const auto stopped = parts_.manager.Stop(component, Left(deadline));
  if (!stopped && stopped.error().code == ErrorCode::kTimeout) {
    return Error{ErrorCode::kTimeout, "component '" + component +
                                          "' is not removed, because it did not stop in time: " +
                                          stopped.error().message};
  }
  auto removed = parts_.manager.Remove(component, Left(deadline));
  if (!removed) (void)Reconnect(connections);
  return removed;
}

std::vector<ConnectionDescription> LifecycleExecutor::ConnectionsOf(
    const std::string& component) const {
  std::vector<ConnectionDescription> connections = parts_.manager.connections();
  std::erase_if(connections, [&](const ConnectionDescription& one) {
    const bool is_own = one.required.component == component;
    const bool is_served =
        one.provided.component == component && one.provided.process == one.required.process;
    return !is_own && !is_served;
  });
  return connections;
}

Result<void> LifecycleExecutor::Add(ComponentFactory::CreatedParts made) {
  try {
    parts_.manager.Add(std::move(made.component), std::move(made.origin));
    return {};
  } catch (const ConfigurationError& error) {  // the program has added a component with this name
    return Error{ErrorCode::kExists, error.what()};
  }
}

/// Tries to make all connections. The error names the first connection that failed.
Result<void> LifecycleExecutor::Reconnect(const std::vector<ConnectionDescription>& connections) {
  Result<void> outcome;
  for (const ConnectionDescription& one : connections) {
    const auto made = parts_.manager.Connect(one.required, one.provided);
    if (made || !outcome || IsAmong(parts_.manager.connections(), one)) continue;
    outcome = Error{made.error().code, "configured, but " + ToString(one.required) +
                                           " is no longer connected to " + ToString(one.provided) +
                                           ": " + made.error().message};
  }
  return outcome;
}

Result<ComponentDescription> LifecycleExecutor::FindOfClass(const std::string& component,
                                                            const std::string& what) const {
  auto found = Find(component);
  if (!found) return found;
  const auto settings = parts_.manager.SettingsOf(component);
  if (settings && !settings->followers.empty()) {
    return Error{ErrorCode::kFailed, "component '" + component + "' cannot be " + what +
                                         " remotely, because '" + settings->followers.front() +
                                         "' runs after it; remove that component first"};
  }
  if (!found->class_name.empty()) return found;
  return Error{ErrorCode::kFailed,
               "component '" + component + "' cannot be " + what +
                   " remotely, because the program of process '" + parts_.process +
                   "' created the component itself; it can only be started and stopped"};
}

Result<ComponentDescription> LifecycleExecutor::Find(const std::string& component) const {
  std::vector<std::string> names;
  for (ComponentDescription& one : parts_.manager.components()) {
    if (one.name == component) return std::move(one);
    names.push_back(one.name);
  }
  return Error{ErrorCode::kNotFound,
               "no component '" + component + "'" + DidYouMean(component, names)};
}

}  // namespace tendon
