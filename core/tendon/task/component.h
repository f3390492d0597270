#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/base/name.h>
#include <tendon/base/result.h>
#include <tendon/base/source_location.h>
#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/inbox.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/notice_list.h>
#include <tendon/task/component_state.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The time for which a request waits by default until the component is in the requested state.
inline constexpr std::chrono::nanoseconds kDefaultTimeout = std::chrono::seconds(10);
/// The request does not wait: the state changes later, when the component's thread handles the
/// request.
inline constexpr std::chrono::nanoseconds kNoWait{0};

/// A named object with interfaces and a lifecycle. It has no thread of its own. While it is active,
/// its commands and event handlers run in the threads that call them. A Task is a component with a
/// thread.
///
/// If a function of the author throws an exception, only this component becomes faulted. Then calls
/// from its peers, including reads, return kNotActive. Peers that wait for a call or an event of
/// the component stop waiting; a wait for an event returns kNotActive. Queued calls are dropped.
/// The connections stay, and work again after a restart. The tables can still be read through the
/// component's `state` interfaces.
///
/// The constructor of a derived class adds the interfaces. The class overrides Configure() and the
/// functions after it as needed. A manager owns the component and controls its lifecycle. The
/// functions below "For managers" may be called by only one thread at a time.
class Component {
 public:
  explicit Component(std::string name);
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The present state. Any thread.
  [[nodiscard]] ComponentState state() const noexcept { return state_.Get(); }
  /// The reason of the fault: the function that threw the exception, and the message of the
  /// exception. Any thread; allocates memory.
  [[nodiscard]] std::string fault() const;
  /// The wall-clock time of the fault; the epoch (1970) if there was no fault. Any thread.
  [[nodiscard]] std::chrono::system_clock::time_point fault_time() const;
  /// The time between two cycles in seconds; 0 if there is no period.
  [[nodiscard]] virtual double period() const { return 0.0; }
  /// Empty if the component is not a task.
  [[nodiscard]] virtual std::vector<const StateTable*> tables() const { return {}; }

  /// The Find functions return null if there is no such interface.
  [[nodiscard]] ProvidedInterface* FindProvided(const std::string& name) const;
  [[nodiscard]] RequiredInterface* FindRequired(const std::string& name) const;
  [[nodiscard]] std::vector<ProvidedDescription> provided() const;
  [[nodiscard]] std::vector<RequiredDescription> required() const;

  /// Waits until the component is in this state. Fails with kTimeout if this takes longer than
  /// `timeout`, and with kFailed if the component is faulted. Any thread except the component's
  /// own.
  Result<void> WaitFor(ComponentState state, std::chrono::nanoseconds timeout);

 protected:
  /// For components whose calls are queued in an inbox until a thread executes them.
  Component(std::string name, std::unique_ptr<Inbox> inbox);

  /// Adds an interface. Throws ConfigurationError for a duplicate or invalid name, and after
  /// Seal(). The names `state` and `state-...` are reserved for state tables.
  ProvidedInterface& AddProvidedInterface(LocatedName name);
  RequiredInterface& AddRequiredInterface(LocatedName name, Need need = Need::kRequired);

  /// Called before the first start, and before a restart after a fault. May throw.
  virtual void Configure() {}
  /// Called before the first cycle, in the component's thread if it has one. May throw.
  virtual void Startup() {}
  /// Called after the last cycle, in the component's thread if it has one. The connections still
  /// work, so commands that this function sends reach their servers. May throw.
  virtual void Cleanup() {}

  // The next four functions are notifications of changes. They are called in the component's
  // thread, before the next Run(). They may throw, and must return within the time of a cycle. A
  // cycle without a change costs nothing more. If something changes while the component does not
  // run, they are called before Startup(); if it is suspended, they are called before OnResume().

  /// Called when `interface` has a new peer. Everything may differ from the last peer, for example
  /// the position of the robot.
  ///
  /// During this function, calls already reach the new peer. However, if other threads may also
  /// call through the interface, calls reach the peer only after this function has returned. For a
  /// component without a thread, this function runs in the thread that connects, in any state.
  virtual void OnConnected(RequiredInterface& /*interface*/) {}
  /// Called when `interface` has lost its peer. Until the next OnConnected(), calls return
  /// kNotConnected, and no events arrive. For a component without a thread, this function runs in
  /// the thread that disconnects, and calls still reach the peer until it returns, if the peer
  /// exists.
  virtual void OnDisconnected(RequiredInterface& /*interface*/) {}
  /// Called when the component continues after a suspension, because its environment may have
  /// changed.
  virtual void OnResume() {}
  /// Called when a client of `interface` was disconnected or lost, while the component runs or when
  /// it resumes. No more calls of this client will be executed. `client` is the name that the
  /// manager uses: "teleoperation/Robot" in this process, "desk/teleoperation/Robot" in another
  /// process.
  ///
  /// For a component without a thread, this function runs at once, in the thread that disconnects.
  /// Consoles and windows that call commands by name are not clients.
  virtual void OnClientGone(ProvidedInterface& /*interface*/, const std::string& /*client*/) {}

 public:
  // For managers.

  /// Ends the construction: no interface and no member can be added from now on.
  virtual void Seal();
  /// These functions request a change of the state, and wait for the new state like WaitFor(). A
  /// request fails with kFailed if the table of transitions (component_state.h) does not allow it.
  ///
  /// Start() first calls Configure() in the calling thread, if needed. It calls `proceed` before
  /// and after Configure(); if `proceed` returns false, Start() fails with kFailed and does not
  /// start the component. Stop() is also allowed during a start. Then the component ends before it
  /// runs, or as soon as its Startup() has returned.
  Result<void> Start(std::chrono::nanoseconds timeout = kDefaultTimeout,
                     const std::function<bool()>& proceed = {});
  Result<void> Suspend(std::chrono::nanoseconds timeout = kDefaultTimeout);
  Result<void> Stop(std::chrono::nanoseconds timeout = kDefaultTimeout);
  /// Like WaitFor(), but also fails with kFailed if the component is stopped before it reaches this
  /// state.
  Result<void> WaitForEffect(ComponentState state, std::chrono::nanoseconds timeout);
  /// Returns true during a start: from the request until the component is active, faulted or
  /// stopped.
  [[nodiscard]] bool is_starting() const noexcept { return is_starting_.Get(); }
  /// Returns true if a stop was requested and the component has not ended yet. During this time it
  /// refuses other requests.
  [[nodiscard]] bool is_stopping() const noexcept { return is_stopping_.Get(); }
  /// Returns true if the component is not active, suspended or starting. Then none of its functions
  /// is running.
  [[nodiscard]] bool is_at_rest() const;
  /// Stops the component if it runs, and waits without a time limit until it has ended. Afterwards
  /// it can be destroyed.
  void End();
  /// The fill level of the component's fullest mailbox; zeros if it has no mailbox. Any thread;
  /// locks a mutex.
  [[nodiscard]] Inbox::Fill mailbox_fill() const;
  /// `observer` is called after each state change, in the thread that made the change. It must not
  /// call this component.
  void SetStateObserver(std::function<void()> observer);

 protected:
  // These functions implement the requests. They are called only if the request is allowed, and
  // need not wait until it takes effect.

  /// Starts the component, which then runs until Halt(). A task starts its thread.
  virtual Result<void> Launch();
  virtual void Pause();
  virtual Result<void> Resume();
  virtual void Halt();
  /// Called repeatedly by a thread that waits for a state. If no other thread does the work of the
  /// component, this function does it.
  virtual void ServeWaiting() {}

  // These functions are for derived kinds of components, such as Task. They must be called in the
  // thread that runs the author's functions. They return false if a function of the author has
  // thrown; then the component is faulted.

  /// Calls OnConnected(), OnDisconnected() and OnClientGone() for all changes that are not reported
  /// yet.
  bool ReportConnections();
  /// Calls ReportConnections(), then OnResume().
  bool ReportResume();
  /// Calls OnConnected() and OnDisconnected() before a start. Does not call OnClientGone(), because
  /// effects of a lost client's calls have already ended with the last run.
  bool ReportBeforeStartup();
  /// Ends the effects of commands that have expired at `now` because no call has renewed them.
  void EndExpired(SteadyTime now);
  /// Returns the time when the next effect of a command expires. Returns the largest time if no
  /// effect expires.
  [[nodiscard]] SteadyTime next_expiry() const noexcept;

  /// These two functions are called in the thread of a manager when the peer of `interface` has
  /// changed or a client is gone.
  virtual void DeliverPeerChange(RequiredInterface& interface);
  virtual void DeliverDisconnectedClient(DisconnectedClient client);
  void QueueGoneClient(DisconnectedClient client);

  /// Calls one of the author's functions. If it throws, the component becomes faulted, and the
  /// reason of the fault begins with `where`.
  template <typename Body>
  bool RunGuarded(const char* const& where, Body body) {
    try {
      body();
      return true;
    } catch (...) {
      EnterFault(where, ReasonOf(std::current_exception()));
      return false;
    }
  }
  void EnterFault(const char* where, const std::string& reason);
  /// The beginning of the reason if a command or event handler throws.
  static constexpr const char* kInHandler = "a command or event handler";
  /// Called when a handler of the component has thrown in a thread that does not belong to the
  /// component. If the component does not run, only logs the reason.
  virtual void FaultFromOutside(const std::string& reason);
  void SetState(ComponentState state);

  ProvidedInterface& AddReservedInterface(LocatedName name);
  [[nodiscard]] Inbox* inbox() const { return inbox_.get(); }

 private:
  // These members are private, because protected names could collide with names in the author's
  // class.

  Result<void> WaitForState(ComponentState wanted, std::chrono::nanoseconds timeout,
                            bool ends_with_a_stop);
  bool ReportPeers(RequiredInterface& interface);
  bool ReportGoneClient(const DisconnectedClient& client);

  std::string name_;
  ComponentAccess access_{ComponentAccess::Listeners{
      .on_exception = [this](const std::string& reason) { FaultFromOutside(reason); },
      .on_peer_changed = [this](RequiredInterface& interface) { DeliverPeerChange(interface); },
      .on_client_gone =
          [this](DisconnectedClient client) { DeliverDisconnectedClient(std::move(client)); }}};
  std::unique_ptr<Inbox> inbox_;
  bool sealed_ = false;
  std::vector<std::unique_ptr<ProvidedInterface>> provided_;
  std::vector<std::unique_ptr<RequiredInterface>> required_;
  std::map<std::string, SourceLocation> added_at_;
  std::vector<Expiry*> expiries_;
  NoticeList<DisconnectedClient> gone_clients_;
  Published<ComponentState> state_{ComponentState::kConstructed};
  Flag is_starting_;
  Flag is_stopping_;
  mutable std::mutex mutex_;  // protects fault_, fault_time_, observer_ and changes of the state
  std::condition_variable changed_;
  std::string fault_;
  std::chrono::system_clock::time_point fault_time_;
  std::function<void()> observer_;
};

}  // namespace tendon
