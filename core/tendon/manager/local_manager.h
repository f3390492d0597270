#pragma once

#include <tendon/base/result.h>
#include <tendon/interface/connection.h>
#include <tendon/manager/description.h>
#include <tendon/manager/orderly_end.h>
#include <tendon/manager/turns.h>
#include <tendon/manager/watchdog.h>
#include <tendon/task/component.h>
#include <tendon/task/thread_options.h>

#include <chrono>
#include <concepts>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

using ConnectionId = std::uint64_t;

/// Where a component came from; shown to people.
struct ComponentOrigin {
  std::string class_name;
  std::string library;
  std::string added_at{};       ///< "robot.cpp:23", where its author's code has added it
  std::string configuration{};  ///< JSON, as its class was told; empty where it was told nothing
};

/// How a component runs, beyond what its class and configuration say.
struct RunSettings {
  std::optional<ThreadOptions> thread{};  ///< none where it has no thread of its own
  std::string leader{};                   ///< the component after which it runs, or empty
  std::vector<std::string> followers{};   ///< those that run after it
  bool is_at_rest = true;                 ///< neither running nor starting
};

/// As LocalManager::Counts() tells it.
[[nodiscard]] ConnectionCounts CountsOf(const Connection& connection);

/// The local component manager: owns the components of one process and the connections between
/// them. Several may live in a process. A Process is one with a network.
///
/// Thread-safe, except that no function is called from a component's own thread. Requests take a
/// lock and wait for threads to end; nothing here belongs in a cycle. One that takes its time in a
/// component's own functions holds up further requests of that component, and no others.
class LocalManager {
 public:
  LocalManager() = default;
  LocalManager(const LocalManager&) = delete;
  LocalManager& operator=(const LocalManager&) = delete;
  /// Stops everything in order, as StopAll() does within kEndPatience, then disconnects and
  /// destroys it; waits for components that are busy in their own functions, as long as it takes.
  virtual ~LocalManager();

  /// Makes a component T(name, arguments...) and takes it in. ConfigurationError when the name is
  /// taken.
  template <std::derived_from<Component> T, typename... Arguments>
  T& Add(PlacedName name, Arguments&&... arguments) {
    auto component =
        std::make_unique<T>(std::move(name.text), std::forward<Arguments>(arguments)...);
    T& reference = *component;
    Add(std::move(component), {.class_name = {}, .library = {}, .added_at = ToString(name.place)});
    return reference;
  }
  Component& Add(std::unique_ptr<Component> component, ComponentOrigin origin);

  /// Stops it while its connections stand, lets servers execute what it has sent last, disconnects
  /// it and destroys it. kTimeout when it does not stop: it is still there then, without its
  /// connections.
  Result<void> Remove(const std::string& component, Patience patience = kPatience);

  /// Puts `component` in the place of the one of its name, which is destroyed: nobody finds none
  /// meanwhile, and observers see one change. It runs after the same leader, and has those
  /// connections within this process that it fits; what it has across the network ends. kFailed
  /// where the one of its name is not at rest, or others run after it; kTimeout as RunAfter():
  /// nothing has changed then.
  Result<void> Replace(std::unique_ptr<Component> component, ComponentOrigin origin,
                       Patience patience = kPatience);

  /// Connects a required to a provided interface, at any time. Errors: kNotFound with a suggestion,
  /// kExists, kIncompatible with the reason. An end without a process means this process.
  virtual Result<ConnectionId> Connect(const InterfaceName& required,
                                       const InterfaceName& provided);
  /// What its ends have accepted and do not execute within kDrainPatience is dropped; the log says
  /// how much.
  virtual Result<void> Disconnect(const InterfaceName& required);

  /// From its next start on, `component` makes a cycle after each one of `leader`, in that one's
  /// thread: ThreadedTask::RunAfter(). kFailed where it is not at rest, has no thread to give up,
  /// or where the two would wait for each other; kTimeout where a cycle of its former leader does
  /// not end within `patience`: nothing has changed then.
  Result<void> RunAfter(const std::string& component, const std::string& leader,
                        Patience patience = kPatience);

  /// What the table of transitions says (component_state.h); waits for the state it leads to, and
  /// kTimeout says that it has not come within `patience`.
  Result<void> Start(const std::string& component, Patience patience = kPatience);
  /// The same, for who may be told to stop it meanwhile: Component::Start() has `proceed`.
  Result<void> Start(const std::string& component, Patience patience,
                     std::function<bool()> proceed);
  Result<void> Suspend(const std::string& component, Patience patience = kPatience);
  /// Those that run after it stop before it. Waits for servers to execute what its Cleanup() has
  /// sent last, for at most kDrainPatience.
  Result<void> Stop(const std::string& component, Patience patience = kPatience);
  /// All that are not active, one after the other: in the order they were added, those that run
  /// after another one after it. `patience` is that for all of them; the first error, but the
  /// others are started all the same.
  Result<void> StartAll(Patience patience = kPatience);
  /// All that are active, in the reverse order.
  Result<void> SuspendAll(Patience patience = kPatience);
  /// All that run: clients before their servers, which first execute what those have sent last; and
  /// those that run after another one before it. Those that do not depend on each other stop at the
  /// same time. Where connections lead around in a circle, one ends before its client: always the
  /// same, which the order decides in which they were added.
  Result<void> StopAll(Patience patience = kPatience);
  /// Returns once they are in that state: kTimeout when they are not within `patience`, kFailed
  /// when one is faulted meanwhile.
  Result<void> WaitFor(const std::string& component, ComponentState state, Patience patience);
  Result<void> WaitForAll(ComponentState state, Patience patience);

  /// Null where there is none; valid until it is removed.
  [[nodiscard]] Component* Find(const std::string& component) const;
  [[nodiscard]] std::vector<ComponentDescription> components() const;
  [[nodiscard]] Result<RunSettings> SettingsOf(const std::string& component) const;
  /// One of which an end is faulted is pending, with the reason, until that was started anew.
  [[nodiscard]] virtual std::vector<ConnectionDescription> connections() const;
  /// kNotFound where it is not connected, kFailed where the connection does not stand.
  [[nodiscard]] virtual Result<ConnectionCounts> Counts(const InterfaceName& required) const;
  /// kNotFound where there is no such component.
  [[nodiscard]] Result<MailboxFill> FillOf(const std::string& component) const;

  /// How long a disconnect lets servers execute what they have accepted.
  static constexpr std::chrono::milliseconds kDrainPatience{500};
  /// How long the end of a manager waits for its components, all together, before it disconnects
  /// them: with what follows, a program that is told to end does so within 2 s.
  static constexpr std::chrono::milliseconds kEndPatience{1300};

 protected:
  /// Either end, or kNotFound with a suggestion.
  Result<RequiredInterface*> FindRequired(const InterfaceName& name) const;
  Result<ProvidedInterface*> FindProvided(const InterfaceName& name) const;
  /// Held while components and connections are looked up or changed; recursive calls of the public
  /// functions are allowed.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> Lock() const;
  /// Called after every change of components, states or connections, in the thread that made it,
  /// which may be a component's that faults: it must be quick and must not call back. Not called
  /// any more once another one, or none, is set.
  void SetObserver(std::function<void()> observer);
  /// Tells the observer.
  void NotifyChanged() const;
  ConnectionId NextConnectionId() { return ++last_connection_; }
  /// Called with the lock held before a component goes, so that what else is tied to it can go
  /// first.
  virtual void OnRemoving(const Component& /*component*/) {}
  /// Whether calls that the component has sent, and its servers can execute, are not executed yet.
  [[nodiscard]] virtual bool HasCallsUnderWay(const Component& client) const;
  // For destructors of derived classes: what ~LocalManager() does.
  /// As StopAll(), with a deadline; what did not end in order is in the log.
  void EndAll(SteadyTime deadline);
  void Clear();

 private:
  struct Entry {
    std::shared_ptr<Component> component;  // shared with those that wait for its state
    ComponentOrigin origin;
  };
  using Components = std::vector<std::shared_ptr<Component>>;
  using Request = std::function<Result<void>(Component&)>;
  struct LocalConnection {
    ConnectionDescription description;
    std::unique_ptr<Connection> connection;
  };

  /// Ready to be taken in.
  Entry MakeEntry(std::unique_ptr<Component> component, ComponentOrigin origin);
  [[nodiscard]] ComponentDescription Describe(const Entry& entry) const;
  [[nodiscard]] Result<std::shared_ptr<Component>> Require(const std::string& component) const;
  /// All of them, each after the one it runs after.
  [[nodiscard]] Components InOrder() const;
  using IsMeant = std::function<bool(const Component&)>;
  /// Those that are meant, each after its clients and those that run after it.
  [[nodiscard]] std::vector<OrderlyEnd::Member> InEndOrder(const IsMeant& is_meant) const;
  Result<void> StopInOrder(const IsMeant& is_meant, SteadyTime deadline);
  [[nodiscard]] bool IsAtRest(const Component& component) const;
  /// Until what it has sent is executed; the log says where it is not by `deadline`.
  void LetExecute(const Component& client, SteadyTime deadline) const;
  Result<void> Ask(const std::string& component, const Request& request, ComponentState wanted,
                   Patience patience);
  Result<void> AskAll(const Components& components, const Request& request, ComponentState wanted,
                      Patience patience);
  /// Makes a request once those made of the component before are; does not wait for its effect.
  Result<void> MakeRequest(const std::shared_ptr<Component>& component, const Request& request,
                           SteadyTime deadline);
  [[nodiscard]] static Error TurnTaken(const std::string& component);
  [[nodiscard]] std::vector<std::string> component_names() const;
  [[nodiscard]] Result<ConnectionId> FindConnection(const InterfaceName& required) const;
  /// Closes a connection and says what that has dropped.
  static void Close(const LocalConnection& connection, std::chrono::milliseconds patience);
  /// With the lock held; tells nobody.
  Result<ConnectionId> Join(const InterfaceName& required, const InterfaceName& provided);
  void DisconnectAll(const std::string& component);
  /// Tries with the lock held, again and again until it is no kTimeout; others get it in between.
  Result<void> Retry(Patience patience, const std::function<Result<void>(SteadyTime)>& attempt);
  Result<void> TryRunAfter(const std::string& component, const std::string& leader,
                           SteadyTime deadline);
  Result<void> TryTakeOut(const std::shared_ptr<Component>& component, SteadyTime deadline);
  /// What was in its place is in `given` afterwards.
  Result<void> TryReplace(Entry& given, SteadyTime deadline);
  void PutInPlace(Entry& given, Component& former);
  void TakeIn(Component& component);
  void LetGo(Component& component);

  mutable std::recursive_mutex mutex_;
  std::vector<Entry> entries_;
  Turns turns_;  // of requests; under mutex_
  std::map<ConnectionId, LocalConnection> connections_;
  ConnectionId last_connection_ = 0;
  mutable std::mutex observer_mutex_;
  std::function<void()> observer_;
  Watchdog watchdog_{[this] { NotifyChanged(); }};  // its thread ends before the rest goes
};

}  // namespace tendon
