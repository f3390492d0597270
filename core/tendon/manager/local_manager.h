#pragma once

#include <tendon/base/result.h>
#include <tendon/interface/connection.h>
#include <tendon/manager/component_description.h>
#include <tendon/manager/orderly_shutdown.h>
#include <tendon/manager/request_serializer.h>
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

/// The origin of a component; shown to people.
struct ComponentOrigin {
  std::string class_name;
  std::string library;
  std::string added_at{};       ///< "robot.cpp:23": the source line that added the component
  std::string configuration{};  ///< JSON, as given to the component; empty if none was given
};

/// How a component runs, apart from its class and configuration.
struct RunSettings {
  std::optional<ThreadOptions> thread{};  ///< empty if it has no thread of its own
  std::string leader{};                   ///< the component after which it runs, or empty
  std::vector<std::string> followers{};   ///< the components that run after it
  bool is_at_rest = true;                 ///< neither running nor starting
};

/// The result of LocalManager::Counts() for a local connection.
[[nodiscard]] ConnectionCounts CountsOf(const Connection& connection);

/// The local component manager: owns the components of one process and the connections between
/// them. A process may have several. Process is a LocalManager with a network.
///
/// Thread-safe, but no function may be called from a component's own thread. Requests take a lock
/// and wait for threads to end, so nothing here belongs in a cycle. While a request waits for a
/// component's own functions, only further requests for the same component are delayed.
class LocalManager {
 public:
  LocalManager() = default;
  LocalManager(const LocalManager&) = delete;
  LocalManager& operator=(const LocalManager&) = delete;
  /// Stops all components in order, as StopAll() does within kEndPatience, then disconnects and
  /// destroys them. Waits without a limit for components that are busy in their own functions.
  virtual ~LocalManager();

  // Components.

  /// Creates a component T(name, arguments...) and adds it. Throws ConfigurationError if the name
  /// is taken.
  template <std::derived_from<Component> T, typename... Arguments>
  T& Add(LocatedName name, Arguments&&... arguments) {
    auto component =
        std::make_unique<T>(std::move(name.text), std::forward<Arguments>(arguments)...);
    T& reference = *component;
    Add(std::move(component),
        {.class_name = {}, .library = {}, .added_at = ToString(name.location)});
    return reference;
  }
  Component& Add(std::unique_ptr<Component> component, ComponentOrigin origin);

  /// Stops the component while its connections still work, lets servers execute its last calls,
  /// then disconnects and destroys it. kTimeout if the component does not stop; then it still
  /// exists, but without connections.
  Result<void> Remove(const std::string& component, Patience patience = kPatience);

  /// Replaces the component with the same name by `component`, and destroys the old one. The name
  /// exists all the time, and observers see one change. The new component runs after the same
  /// leader. Connections within this process are kept if the new component fits them; connections
  /// across the network end. kFailed if the old component is not at rest, or others run after it;
  /// kTimeout as in RunAfter(). On an error nothing has changed.
  Result<void> Replace(std::unique_ptr<Component> component, ComponentOrigin origin,
                       Patience patience = kPatience);

  // Connections.

  /// Connects a required to a provided interface, at any time. Errors: kNotFound with a suggestion,
  /// kExists, kIncompatible with the reason. A name without a process means this process.
  virtual Result<ConnectionId> Connect(const InterfaceName& required,
                                       const InterfaceName& provided);
  /// Drops accepted calls and events that are not executed within kDrainPatience, and logs their
  /// number.
  virtual Result<void> Disconnect(const InterfaceName& required);

  // Lifecycle.

  /// From its next start on, `component` makes a cycle after each cycle of `leader`, in the
  /// leader's thread: ThreadedTask::RunAfter(). kFailed if the component is not at rest, never has
  /// a thread of its own, or the two would wait for each other. kTimeout if a cycle of the former
  /// leader does not end within `patience`; then nothing has changed.
  Result<void> RunAfter(const std::string& component, const std::string& leader,
                        Patience patience = kPatience);

  /// Each request follows the table of transitions (component_state.h) and waits for the target
  /// state; kTimeout if the component does not reach it within `patience`.
  Result<void> Start(const std::string& component, Patience patience = kPatience);
  /// The same for a start that may be cancelled meanwhile: see `proceed` of Component::Start().
  Result<void> Start(const std::string& component, Patience patience,
                     std::function<bool()> proceed);
  Result<void> Suspend(const std::string& component, Patience patience = kPatience);
  /// Components that run after this one stop first. After the stop, waits for at most
  /// kDrainPatience until servers have executed the last calls of its Cleanup().
  Result<void> Stop(const std::string& component, Patience patience = kPatience);
  /// Brings a component at rest to the state that a file requests. For kActive, starts it; for
  /// kSuspended, starts and then suspends it; for any other state, does nothing. If the suspension
  /// fails within `patience`, stops the component, because it must not run. The error also says in
  /// which state the component is left.
  Result<void> TransitionTo(const std::string& component, ComponentState wanted,
                            Patience patience = kPatience);
  /// Starts all components that are not active, one by one, in the order in which they were added,
  /// but leaders before the components that run after them. `patience` is the total time. Starts
  /// the others even if one fails; returns the first error.
  Result<void> StartAll(Patience patience = kPatience);
  /// Suspends all active components, in the reverse order.
  Result<void> SuspendAll(Patience patience = kPatience);
  /// Stops all running components: clients before their servers, which first execute the clients'
  /// last calls, and components before their leaders. Components that do not depend on each other
  /// stop at the same time. In a cycle of connections, one component stops before its client; the
  /// order in which components were added decides which one.
  Result<void> StopAll(Patience patience = kPatience);
  /// Waits until all components are in that state. kTimeout: not within `patience`; kFailed: one is
  /// faulted.
  Result<void> WaitFor(const std::string& component, ComponentState state, Patience patience);
  Result<void> WaitForAll(ComponentState state, Patience patience);

  // Descriptions of components and connections.

  /// Null if there is none; valid until the component is removed.
  [[nodiscard]] Component* Find(const std::string& component) const;
  [[nodiscard]] std::vector<ComponentDescription> components() const;
  [[nodiscard]] Result<RunSettings> SettingsOf(const std::string& component) const;
  /// A connection to a faulted component is pending, with the reason, until that component is
  /// restarted.
  [[nodiscard]] virtual std::vector<ConnectionDescription> connections() const;
  /// kNotFound if `required` is not connected, kFailed if the connection is not active.
  [[nodiscard]] virtual Result<ConnectionCounts> Counts(const InterfaceName& required) const;
  /// kNotFound if there is no such component.
  [[nodiscard]] Result<MailboxFill> FillOf(const std::string& component) const;

  /// How long a disconnect waits for servers to execute accepted calls.
  static constexpr std::chrono::milliseconds kDrainPatience{500};
  /// How long the destructor waits for all components to stop before it disconnects them. So a
  /// program ends within 2 s of a termination request.
  static constexpr std::chrono::milliseconds kEndPatience{1300};

 protected:
  /// The interface, or kNotFound with a suggestion.
  Result<RequiredInterface*> FindRequired(const InterfaceName& name) const;
  Result<ProvidedInterface*> FindProvided(const InterfaceName& name) const;
  /// Locks the manager against other lookups and changes of components and connections. The holder
  /// may call the public functions.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> Lock() const;
  /// `observer` is called after every change of components, states or connections, in the thread
  /// that made the change, which may be the thread of a faulting component. It must be quick and
  /// must not call this object. After the return, the former observer is not called any more.
  void SetObserver(std::function<void()> observer);
  /// Calls the observer.
  void NotifyChanged() const;
  ConnectionId NextConnectionId() { return ++last_connection_; }
  /// Called with the lock held, before a component is removed, so that everything that depends on
  /// it can be removed first.
  virtual void OnRemoving(const Component& /*component*/) {}
  /// True if calls sent by `client` still wait at servers that can execute them.
  [[nodiscard]] virtual bool HasCallsUnderWay(const Component& client) const;
  // For destructors of derived classes: the steps of ~LocalManager().
  /// Like StopAll(), with a deadline; logs the components that did not end in order.
  void EndAll(SteadyTime deadline);
  void Clear();

 private:
  struct Entry {
    std::shared_ptr<Component> component;  // shared with threads that wait for its state
    ComponentOrigin origin;
  };
  using Components = std::vector<std::shared_ptr<Component>>;
  using Request = std::function<Result<void>(Component&)>;
  struct LocalConnection {
    ConnectionDescription description;
    std::unique_ptr<Connection> connection;
  };

  /// Seals the component; then it is ready for Attach().
  Entry MakeEntry(std::unique_ptr<Component> component, ComponentOrigin origin);
  [[nodiscard]] ComponentDescription Describe(const Entry& entry) const;
  [[nodiscard]] Result<std::shared_ptr<Component>> Require(const std::string& component) const;
  /// All components, leaders before the components that run after them.
  [[nodiscard]] Components InOrder() const;
  using IsMeant = std::function<bool(const Component&)>;
  /// The components for which `is_meant` is true, each one after its clients and after the
  /// components that run after it.
  [[nodiscard]] std::vector<OrderlyShutdown::Member> InEndOrder(const IsMeant& is_meant) const;
  Result<void> StopInOrder(const IsMeant& is_meant, SteadyTime deadline);
  [[nodiscard]] bool IsAtRest(const Component& component) const;
  /// Waits until the calls of `client` are executed; logs a warning if `deadline` passes first.
  void LetExecute(const Component& client, SteadyTime deadline) const;
  Result<void> RequestState(const std::string& component, const Request& request,
                            ComponentState wanted, Patience patience);
  Result<void> RequestStateOfAll(const Components& components, const Request& request,
                                 ComponentState wanted, Patience patience);
  /// Makes a request after all earlier requests for the component; does not wait for its effect.
  Result<void> MakeRequest(const std::shared_ptr<Component>& component, const Request& request,
                           SteadyTime deadline);
  [[nodiscard]] static Error RequestInProgress(const std::string& component);
  [[nodiscard]] std::vector<std::string> component_names() const;
  [[nodiscard]] Result<ConnectionId> FindConnection(const InterfaceName& required) const;
  /// Closes a connection and logs how many calls and events were dropped.
  static void Close(const LocalConnection& connection, std::chrono::milliseconds patience);
  /// With the lock held; does not call the observer.
  Result<ConnectionId> Join(const InterfaceName& required, const InterfaceName& provided);
  void DisconnectAll(const std::string& component);
  /// Calls `attempt` with the lock held until the result is not kTimeout; releases the lock in
  /// between.
  Result<void> Retry(Patience patience, const std::function<Result<void>(SteadyTime)>& attempt);
  Result<void> TryRunAfter(const std::string& component, const std::string& leader,
                           SteadyTime deadline);
  Result<void> TryTakeOut(const std::shared_ptr<Component>& component, SteadyTime deadline);
  /// Afterwards, `given` is the former entry.
  Result<void> TryReplace(Entry& given, SteadyTime deadline);
  void ReplaceEntry(Entry& given, Component& former);
  void Attach(Component& component);
  void Detach(Component& component);

  mutable std::recursive_mutex mutex_;
  std::vector<Entry> entries_;
  RequestSerializer serializer_;  // serialises requests; guarded by mutex_
  std::map<ConnectionId, LocalConnection> connections_;
  ConnectionId last_connection_ = 0;
  mutable std::mutex observer_mutex_;
  std::function<void()> observer_;
  Watchdog watchdog_{[this] { NotifyChanged(); }};  // last member, so that its thread ends first
};

}  // namespace tendon
