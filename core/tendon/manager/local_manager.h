#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/interface/connection.h>
#include <tendon/manager/component_description.h>
#include <tendon/manager/watchdog.h>
#include <tendon/task/component.h>
#include <tendon/task/thread_options.h>

#include <chrono>
#include <concepts>
#include <cstdint>
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

/// Where a component comes from, to be shown to people.
struct ComponentOrigin {
  std::string class_name;
  std::string library;
  std::string added_at{};       ///< "robot.cpp:23": the source line that added the component
  std::string configuration{};  ///< JSON, as given to the component; empty if none was given
};

/// The settings with which a component runs, without its class and configuration.
struct RunSettings {
  std::optional<ThreadOptions> thread{};  ///< empty if it has no thread of its own
  std::string leader{};                   ///< the component after which it runs, or empty
  std::vector<std::string> followers{};   ///< the components that run after it
  bool is_at_rest = true;                 ///< true if it neither runs nor is starting
};

/// Returns the counts of a local connection.
[[nodiscard]] ConnectionCounts CountsOf(const Connection& connection);

class ComponentOrder;
class LocalManager;
class StateRequests;

/// The second base class of a component that works on all components of its manager, such as a
/// recorder.
class ManagerClient {
 public:
  ManagerClient() = default;
  ManagerClient(const ManagerClient&) = delete;
  ManagerClient& operator=(const ManagerClient&) = delete;
  virtual ~ManagerClient();

  /// Called once, before the component is added. If it throws a ConfigurationError, the component
  /// is not added. The manager outlives the component.
  virtual void OnAdding(LocalManager& manager) = 0;
};

/// The local component manager (LCM): owns components of one process and the connections between
/// them. A process may have several managers. The class Process is a LocalManager with a network.
///
/// Thread-safe, but no function may be called in a component's own thread. Requests take a lock and
/// wait for threads, so they must not be made in a cycle. While a request waits for the functions
/// of a component, it delays only other requests for this component.
class LocalManager {
 public:
  LocalManager();
  LocalManager(const LocalManager&) = delete;
  LocalManager& operator=(const LocalManager&) = delete;
  /// Stops all components like StopAll(), within kEndTimeout. Then disconnects and destroys them.
  /// If a component is busy in one of its own functions, waits for it without a time limit.
  virtual ~LocalManager();

  // Components.

  /// Creates a component T(name, arguments...) and adds it. Throws ConfigurationError if a
  /// component with this name exists.
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

  /// Stops the component while its connections still work, and waits until servers have executed
  /// its last calls. Then disconnects and destroys the component. Fails with kTimeout if the
  /// component does not stop; then it still exists, but has no connections.
  Result<void> Remove(const std::string& component,
                      std::chrono::nanoseconds timeout = kDefaultTimeout);

  /// Replaces the component that has the same name as `component`, and destroys the old one. Other
  /// threads always find a component with this name, and the observer is called once. The new
  /// component runs after the same leader. Connections within this process are kept if the new
  /// component fits; connections to other processes end.
  ///
  /// Fails with kFailed if the old component is not at rest or other components run after it, and
  /// with kTimeout like RunAfter(). A failure changes nothing.
  Result<void> Replace(std::unique_ptr<Component> component, ComponentOrigin origin,
                       std::chrono::nanoseconds timeout = kDefaultTimeout);

  // Connections.

  /// Connects a required interface to a provided interface; possible at any time. A name without a
  /// process means this process. Errors: kNotFound (the error suggests a name), kExists,
  /// kIncompatible (the error says why).
  virtual Result<ConnectionId> Connect(const InterfaceName& required,
                                       const InterfaceName& provided);
  /// Disconnects a required interface. Waits up to kDrainTimeout until accepted calls and events
  /// are executed; drops the others and logs their number.
  virtual Result<void> Disconnect(const InterfaceName& required);

  // Lifecycle.

  /// Makes `component` run after `leader` from its next start on: it makes a cycle after each cycle
  /// of `leader`, in the leader's thread (ThreadedTask::RunAfter()). Fails with kFailed if the
  /// component is not at rest or never has a thread of its own, or if the two would run after each
  /// other. Fails with kTimeout, and changes nothing, if a cycle of the former leader does not end
  /// within `timeout`.
  Result<void> RunAfter(const std::string& component, const std::string& leader,
                        std::chrono::nanoseconds timeout = kDefaultTimeout);

  /// These functions request a change of the state, as the table of transitions (component_state.h)
  /// allows, and wait for the new state. They fail with kTimeout if the component does not reach it
  /// within `timeout`.
  Result<void> Start(const std::string& component,
                     std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Starts a component, but lets the caller cancel the start: see `proceed` of Component::Start().
  Result<void> Start(const std::string& component, std::chrono::nanoseconds timeout,
                     std::function<bool()> proceed);
  Result<void> Suspend(const std::string& component,
                       std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Stops a component. Components that run after it are stopped first. After the stop, waits for
  /// at most kDrainTimeout until servers have executed the last calls of its Cleanup().
  Result<void> Stop(const std::string& component,
                    std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Brings a component at rest to the state that a file requests. For kActive, starts it. For
  /// kSuspended, starts and then suspends it. For any other state, does nothing. If the component
  /// cannot be suspended within `timeout`, stops it, because it must not run; the error then says
  /// whether the stop has succeeded.
  Result<void> TransitionTo(const std::string& component, ComponentState wanted,
                            std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Starts all components that are not active, one after the other, in the order in which they
  /// were added, except that leaders come before the components that run after them. `timeout` is
  /// the total time. If a start fails, starts the others nevertheless, and returns the first error.
  Result<void> StartAll(std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Suspends all active components in the reverse order of StartAll().
  Result<void> SuspendAll(std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Stops all running components. Clients are stopped before their servers, so that the servers
  /// can still execute the clients' last calls. Components are stopped before their leaders.
  /// Components that do not depend on each other are stopped at the same time. If connections form
  /// a cycle, one server must be stopped before its client. It is chosen by the order in which the
  /// components were added.
  Result<void> StopAll(std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// These functions wait until the component, or all components, are in this state. They fail with
  /// kTimeout if this takes longer than `timeout`, and with kFailed if a component is faulted.
  Result<void> WaitFor(const std::string& component, ComponentState state,
                       std::chrono::nanoseconds timeout);
  Result<void> WaitForAll(ComponentState state, std::chrono::nanoseconds timeout);

  // Descriptions of components and connections.

  /// Returns a component, or null if there is no such component. The pointer is valid until the
  /// component is removed.
  [[nodiscard]] Component* Find(const std::string& component) const;
  [[nodiscard]] std::vector<ComponentDescription> components() const;
  [[nodiscard]] Result<RunSettings> SettingsOf(const std::string& component) const;
  /// Returns the connections. The connections of a faulted component are pending until it is
  /// started again; their reason contains the fault.
  [[nodiscard]] virtual std::vector<ConnectionDescription> connections() const;
  /// Returns the counts of a connection. Fails with kNotFound if `required` is not connected, and
  /// with kFailed if the connection is not active.
  [[nodiscard]] virtual Result<ConnectionCounts> Counts(const InterfaceName& required) const;
  /// Returns the fill level of the component's fullest mailbox. Fails with kNotFound if there is no
  /// such component.
  [[nodiscard]] Result<MailboxFill> FillOf(const std::string& component) const;

  /// The time for which a disconnect waits until servers have executed accepted calls.
  static constexpr std::chrono::milliseconds kDrainTimeout{500};
  /// The time for which the destructor waits until all components have stopped, before it
  /// disconnects them. This time lets a program end within 2 s after a termination request.
  static constexpr std::chrono::milliseconds kEndTimeout{1300};

 protected:
  /// These functions return an interface. They fail with kNotFound; the error suggests a name.
  Result<RequiredInterface*> FindRequired(const InterfaceName& name) const;
  Result<ProvidedInterface*> FindProvided(const InterfaceName& name) const;
  /// Locks the components and connections of the manager: other threads can neither read nor change
  /// them. The holder of the lock may call the public functions.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> Lock() const;
  /// Locks like Lock(), but does not wait. Returns an empty lock if another thread holds it.
  [[nodiscard]] std::unique_lock<std::recursive_mutex> TryLock() const;
  /// Sets a function that is called after every change of components, states or connections. It is
  /// called in the thread that made the change, for example in the thread of a component that
  /// becomes faulted. The function must be quick and must not call this object. After SetObserver()
  /// has returned, the former observer is not called.
  void SetObserver(std::function<void()> observer);
  /// Calls the observer.
  void NotifyChanged() const;
  ConnectionId NextConnectionId() { return ++last_connection_; }
  /// Called under the lock before a component is removed. A derived class can then remove
  /// everything that depends on the component.
  virtual void OnRemoving(const Component& /*component*/) {}
  /// OnAttached() is called after a component was added to this manager, and OnDetached() before it
  /// is removed. At these calls, the lock is held and the component does not run. They must not
  /// throw.
  virtual void OnAttached(Component& /*component*/) {}
  virtual void OnDetached(const Component& /*component*/) {}
  /// Returns true if calls of `client` are still queued at servers that can execute them.
  [[nodiscard]] virtual bool HasCallsUnderWay(const Component& client) const;
  // The steps of ~LocalManager(), for destructors of derived classes.
  /// Like StopAll(), but with a deadline; logs the first error.
  void EndAll(SteadyTime deadline);
  void Clear();

 private:
  struct Entry {
    std::shared_ptr<Component> component;  // shared, because threads may wait for its state
    ComponentOrigin origin;
  };
  struct LocalConnection {
    ConnectionDescription description;
    std::unique_ptr<Connection> connection;
  };

  /// Seals the component and returns an entry for it, which is ready for Attach().
  Entry MakeEntry(std::unique_ptr<Component> component, ComponentOrigin origin);
  [[nodiscard]] ComponentDescription Describe(const Entry& entry) const;
  [[nodiscard]] Result<std::shared_ptr<Component>> Require(const std::string& component) const;
  /// Called while the lock is held.
  [[nodiscard]] ComponentOrder Order() const;
  [[nodiscard]] std::vector<std::string> component_names() const;
  [[nodiscard]] Result<ConnectionId> FindConnection(const InterfaceName& required) const;
  /// Closes a connection and logs how many calls and events were dropped.
  static void Close(const LocalConnection& connection, std::chrono::milliseconds timeout);
  /// Makes a connection. Called while the lock is held; does not call the observer.
  Result<ConnectionId> Join(const InterfaceName& required, const InterfaceName& provided);
  void DisconnectAll(const std::string& component);
  /// Calls `attempt` repeatedly, while the lock is held, until its result is not kTimeout or
  /// `timeout` is over. Releases the lock between the calls.
  Result<void> Retry(std::chrono::nanoseconds timeout,
                     const std::function<Result<void>(SteadyTime)>& attempt);
  Result<void> TryRunAfter(const std::string& component, const std::string& leader,
                           SteadyTime deadline);
  Result<void> TryTakeOut(const std::shared_ptr<Component>& component, SteadyTime deadline);
  /// Replaces the entry that has the same name as `given`. Afterwards, `given` is the former entry.
  Result<void> TryReplace(Entry& given, SteadyTime deadline);
  void ReplaceEntry(Entry& given, Component& former);
  void Attach(Component& component);
  void Detach(Component& component);

  mutable std::recursive_mutex mutex_;
  std::vector<Entry> entries_;
  std::map<ConnectionId, LocalConnection> connections_;
  ConnectionId last_connection_ = 0;
  const std::unique_ptr<StateRequests> requests_;
  mutable std::mutex observer_mutex_;
  std::function<void()> observer_;
  Watchdog watchdog_{[this] { NotifyChanged(); }};  // last member, so that its thread ends first
};

}  // namespace tendon
