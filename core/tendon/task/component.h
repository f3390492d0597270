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

/// How long a request waits for its target state.
using Patience = std::chrono::nanoseconds;
inline constexpr Patience kPatience = std::chrono::seconds(10);
/// Do not wait: the state changes when the component's thread handles the request.
inline constexpr Patience kNoWait{0};

/// A named object with interfaces and a lifecycle, but without a thread of its own: while it is
/// active, its commands and event handlers run in the threads that call them. A Task adds a thread.
///
/// An exception in one of the author's functions faults the component and nothing else. From then
/// on, calls of its peers, even reads, return kNotActive. Waiting calls end, and waits for its
/// events return kNotActive. Its connections stay and work again after a restart; queued calls are
/// dropped. Its tables stay readable through its `state` interfaces.
///
/// The constructor of a derived class adds the interfaces, and the class overrides Configure() and
/// the functions after it as needed. A manager owns the component and drives its lifecycle. Only
/// one thread at a time may call the functions below "For managers".
class Component {
 public:
  explicit Component(std::string name);
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Any thread.
  [[nodiscard]] ComponentState state() const noexcept { return state_.Get(); }
  /// The reason of the fault: the exception's message and the function that threw. Any thread;
  /// allocates.
  [[nodiscard]] std::string fault() const;
  /// Wall-clock time of the fault; 1970 if there is none. Any thread.
  [[nodiscard]] std::chrono::system_clock::time_point fault_time() const;
  /// Seconds between two cycles; 0 without a period.
  [[nodiscard]] virtual double period() const { return 0.0; }
  /// Empty if the component is not a task.
  [[nodiscard]] virtual std::vector<const StateTable*> tables() const { return {}; }

  /// Null if there is none.
  [[nodiscard]] ProvidedInterface* FindProvided(const std::string& name) const;
  [[nodiscard]] RequiredInterface* FindRequired(const std::string& name) const;
  [[nodiscard]] std::vector<ProvidedDescription> provided() const;
  [[nodiscard]] std::vector<RequiredDescription> required() const;

  /// Waits until the component is in that state. kTimeout: not within `patience`; kFailed: the
  /// component is faulted. Any thread except the component's own.
  Result<void> WaitFor(ComponentState state, Patience patience);

 protected:
  /// For components whose calls wait in an inbox until a thread executes them.
  Component(std::string name, std::unique_ptr<Inbox> inbox);

  /// Throws ConfigurationError for a duplicate or invalid name, or after Seal(). The names `state`
  /// and `state-...` are reserved for state tables.
  ProvidedInterface& AddProvidedInterface(LocatedName name);
  RequiredInterface& AddRequiredInterface(LocatedName name, Need need = Need::kRequired);

  /// Called before the first start, and before a restart after a fault. May throw.
  virtual void Configure() {}
  /// Called before the first cycle, in the component's thread if it has one. May throw.
  virtual void Startup() {}
  /// Called after the last cycle, in the component's thread if it has one. The connections still
  /// work, so commands that it sends reach their servers. May throw.
  virtual void Cleanup() {}

  // Notifications of changes, in the component's thread before its next Run(). They may throw, and
  // must return within the cycle's time. They cost nothing in a cycle without a change. Changes
  // while the component does not run are notified before Startup(); changes while it is suspended,
  // before OnResume().

  /// `interface` has a new peer. Everything may differ from the last peer, such as the position of
  /// the robot. Calls reach the new peer from this call on; if other threads may call too, from its
  /// return on. For a component without a thread, this runs in the thread that connects, in any
  /// state.
  virtual void OnConnected(RequiredInterface& /*interface*/) {}
  /// The peer and its events are gone: calls return kNotConnected until the next OnConnected(). For
  /// a component without a thread, this runs in the thread that disconnects; there, its calls still
  /// reach the peer, if the peer exists.
  virtual void OnDisconnected(RequiredInterface& /*interface*/) {}
  /// The component continues after a suspension. Its environment may have changed meanwhile.
  virtual void OnResume() {}
  /// A client that could call `interface` is disconnected or lost; none of its calls will be
  /// executed any more. Called while the component runs, or after it has resumed. `client` is the
  /// name that the manager uses: "teleoperation/Robot" in this process, "desk/teleoperation/Robot"
  /// in another one. For a component without a thread, this runs at once, in the thread that
  /// disconnects. Consoles and windows that call commands by name are not clients.
  virtual void OnClientGone(ProvidedInterface& /*interface*/, const std::string& /*client*/) {}

 public:
  // For managers.

  /// Ends the construction: no interface and no member can be added from now on.
  virtual void Seal();
  /// The requests follow the table of transitions and wait for the target state like WaitFor(). An
  /// illegal request fails with kFailed. Start() first calls Configure(), in the calling thread, if
  /// needed. Stop() is also legal during a start: the component ends before it runs, or as soon as
  /// its Startup() has returned. `proceed` is called before and after Configure(); if it returns
  /// false, the component is not started, and Start() fails with kFailed.
  Result<void> Start(Patience patience = kPatience, const std::function<bool()>& proceed = {});
  Result<void> Suspend(Patience patience = kPatience);
  Result<void> Stop(Patience patience = kPatience);
  /// Like WaitFor(), for a state that was requested before; kFailed if the component is stopped
  /// instead.
  Result<void> WaitForEffect(ComponentState state, Patience patience);
  /// True from the request to start until the component is active, faulted or stopped.
  [[nodiscard]] bool is_starting() const noexcept { return is_starting_.Get(); }
  /// True if a stop was requested and the component has not ended yet. Until then it refuses other
  /// requests.
  [[nodiscard]] bool is_stopping() const noexcept { return is_stopping_.Get(); }
  /// True if the component is not active, suspended or starting, so that none of its functions
  /// runs.
  [[nodiscard]] bool is_at_rest() const;
  /// Stops the component if it runs, and waits for the end without a limit. Afterwards it can be
  /// destroyed.
  void End();
  /// The fill level of its fullest mailbox; zeros if it has none. Any thread; locks.
  [[nodiscard]] Inbox::Fill mailbox_fill() const;
  /// `observer` runs after each state change, in the thread that made it. It must not call this
  /// component.
  void SetStateObserver(std::function<void()> observer);

 protected:
  // Implementations of the requests, called if the request is legal. They need not wait for the
  // effect.

  /// Lets the component run until Halt(). A task starts its thread.
  virtual Result<void> Launch();
  virtual void Pause();
  virtual Result<void> Resume();
  virtual void Halt();
  /// Called repeatedly in a thread that waits for a state: does the work of a component without a
  /// thread.
  virtual void ServeWaiting() {}

  // For derived kinds of components, in the thread that runs the author's functions. They return
  // false if one of these functions has thrown; then the component is faulted.

  /// Calls OnConnected(), OnDisconnected() and OnClientGone() for all changes.
  bool ReportConnections();
  /// Calls ReportConnections(), then OnResume().
  bool ReportResume();
  /// Calls OnConnected() and OnDisconnected() before a start. Does not call OnClientGone(): the
  /// effects of a client's calls ended with the last run.
  bool ReportBeforeStartup();
  /// Ends the effects of commands that were not renewed by `now`.
  void EndExpired(SteadyTime now);
  /// The time at which the next effect of a command expires; the largest time if there is none.
  [[nodiscard]] SteadyTime next_expiry() const noexcept;

  /// Called in a manager's thread when the peer of `interface` has changed, or a client is gone.
  virtual void DeliverPeerChange(RequiredInterface& interface);
  virtual void DeliverDisconnectedClient(DisconnectedClient client);
  void QueueGoneClient(DisconnectedClient client);

  /// Runs one of the author's functions. An exception faults the component; then `where` names the
  /// place in the error text.
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
  /// The place of the fault if a command or event handler throws.
  static constexpr const char* kInHandler = "a command or event handler";
  /// Called in a foreign thread in which a handler of the component has thrown. Only logs the
  /// reason if the component does not run.
  virtual void FaultFromOutside(const std::string& reason);
  void SetState(ComponentState state);

  ProvidedInterface& AddReservedInterface(LocatedName name);
  [[nodiscard]] Inbox* inbox() const { return inbox_.get(); }

 private:
  // Names in a base class might collide with names of an author's class, so there are no further
  // protected ones.

  Result<void> WaitForState(ComponentState wanted, Patience patience, bool ends_with_a_stop);
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
  mutable std::mutex mutex_;  // guards fault_, its time, observer_, and state changes
  std::condition_variable changed_;
  std::string fault_;
  std::chrono::system_clock::time_point fault_time_;
  std::function<void()> observer_;
};

}  // namespace tendon
