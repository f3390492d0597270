#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/base/name.h>
#include <tendon/base/result.h>
#include <tendon/base/source_place.h>
#include <tendon/interface/execution/host.h>
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

/// How long a request waits for the state it leads to.
using Patience = std::chrono::nanoseconds;
inline constexpr Patience kPatience = std::chrono::seconds(10);
/// Only asks: the state follows when the component's thread gets to it.
inline constexpr Patience kNoWait{0};

/// A named object with interfaces and a life cycle, and no thread of its own: its commands and
/// event handlers run in the threads that call them, as long as it is active. A Task adds a thread.
///
/// An exception in one of the author's functions faults the component and nothing else. Its peers'
/// calls, reads too, return kNotActive from then on, their waits end, and nobody misses its events
/// for ever: waiters are told. Its connections stay, and work again once it was started anew; what
/// waited is dropped. Its tables stay readable through its `state` interfaces.
///
/// The constructor of a derived class adds the interfaces; a manager owns the component and drives
/// its life. Functions below "for managers" are called by one thread at a time.
class Component {
 public:
  explicit Component(std::string name);
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Any thread.
  [[nodiscard]] ComponentState state() const noexcept { return state_.Get(); }
  /// Why it is faulted: the exception's message and where it was thrown. Any thread; allocates.
  [[nodiscard]] std::string fault() const;
  /// When it faulted, by the wall clock; 1970 where it has not. Any thread.
  [[nodiscard]] std::chrono::system_clock::time_point fault_time() const;
  /// s between two cycles, 0 where it has none.
  [[nodiscard]] virtual double period() const { return 0.0; }
  /// Empty unless it is a task.
  [[nodiscard]] virtual std::vector<const StateTable*> tables() const { return {}; }

  /// Null where there is none.
  [[nodiscard]] ProvidedInterface* FindProvided(const std::string& name) const;
  [[nodiscard]] RequiredInterface* FindRequired(const std::string& name) const;
  [[nodiscard]] std::vector<ProvidedDescription> provided() const;
  [[nodiscard]] std::vector<RequiredDescription> required() const;

  /// Returns once it is in that state: kTimeout when it is not within `patience`, kFailed when it
  /// is faulted meanwhile. Any thread but the component's own.
  Result<void> WaitFor(ComponentState state, Patience patience);

  // For managers.

  /// Ends the construction: from now on no interface and no member can be added.
  virtual void Seal();
  /// Each does what the table of transitions says, and waits for the state it leads to as
  /// WaitFor() does; what is illegal is refused with kFailed. Start() configures in the calling
  /// thread where needed. Stop() is legal while it is starting, too: it ends without having run, or
  /// as soon as its Startup() has returned.
  /// Where there is a `proceed`, it is asked before the author's Configure() and after it; where it
  /// says no, the component is not started, which is kFailed.
  Result<void> Start(Patience patience = kPatience, const std::function<bool()>& proceed = {});
  Result<void> Suspend(Patience patience = kPatience);
  Result<void> Stop(Patience patience = kPatience);
  /// As WaitFor(), once it was asked for the state; kFailed when it is stopped instead.
  Result<void> WaitForEffect(ComponentState state, Patience patience);
  /// Whether it was asked to start, and is neither active nor faulted yet.
  [[nodiscard]] bool is_starting() const noexcept { return is_starting_.Get(); }
  /// Whether it was asked to stop, and still runs: until it has ended, nothing else is asked of it.
  [[nodiscard]] bool is_stopping() const noexcept { return is_stopping_.Get(); }
  /// Neither active nor suspended, nor on the way: none of its functions runs.
  [[nodiscard]] bool is_at_rest() const;
  /// Stops it where it runs, and waits for that as long as it takes: it can be destroyed then.
  void End();
  /// How full the fullest of its mailboxes is; 0 of 0 where it has none. Any thread; locks.
  [[nodiscard]] Inbox::Fill mailbox_fill() const;
  /// Called after each change of the state, in the thread that made it; must not call back.
  void SetStateObserver(std::function<void()> observer);

 protected:
  /// For components whose calls wait in an inbox until somebody executes them.
  Component(std::string name, std::unique_ptr<Inbox> inbox);

  /// A second interface of one name, a bad name, or a sealed component: ConfigurationError. The
  /// names `state` and `state-...` are reserved for state tables.
  ProvidedInterface& AddProvidedInterface(PlacedName name);
  RequiredInterface& AddRequiredInterface(PlacedName name, Need need = Need::kRequired);

  /// Before the first start, and again before a restart after a fault. May throw.
  virtual void Configure() {}
  /// Before the first cycle, in the component's thread if it has one. May throw.
  virtual void Startup() {}
  /// After the last cycle, in the component's thread if it has one. Its connections stand: what it
  /// sends arrives. May throw.
  virtual void Cleanup() {}

  // What changes around it while it lives, told before its next Run(), in its own thread. They may
  // throw, cost nothing in a cycle in which nothing changes, and what is called by them must keep
  // to the cycle's time. What changes while it does not run it hears before Startup(), and while it
  // is suspended, before OnResume().

  /// `interface` has another peer: anything may be otherwise than with the last one, such as where
  /// the robot stands. No call has reached it before; from here on calls do. (Where threads of
  /// others call as well, from the return on. A component without a thread hears of it in the
  /// thread that connects, whatever its state.)
  virtual void OnConnected(RequiredInterface& /*interface*/) {}
  /// The peer is gone, and so are its events: calls return kNotConnected until the next
  /// OnConnected(). Who has no thread hears of it in the thread that disconnects, where its calls
  /// reach the peer still, if that is there.
  virtual void OnDisconnected(RequiredInterface& /*interface*/) {}
  /// It was suspended, for how long it may, and goes on: the world is not what it was.
  virtual void OnResume() {}
  /// A client that could call `interface` is disconnected or lost, and nothing that it has sent is
  /// executed any more; told while it runs, or once it is resumed. `client` is named as its manager
  /// knows it: "teleoperation/Robot" in this process, "desk/teleoperation/Robot" in another one.
  /// A component without a thread is told at once, in the thread that disconnects. Consoles and
  /// windows that call commands by name are no clients.
  virtual void OnClientGone(ProvidedInterface& /*interface*/, const std::string& /*client*/) {}

  // What the requests do, once they are known to be legal. They need not wait for their effect.

  /// Lets the component run until Halt(); a task starts its thread.
  virtual Result<void> Launch();
  virtual void Pause();
  virtual Result<void> Resume();
  virtual void Halt();
  /// Called now and then in a thread that waits for a state: for what no thread of its own does.
  virtual void ServeWaiting() {}

  // For kinds of components, in the thread that runs the author's functions. False where one has
  // thrown: it is faulted.

  /// Tells of the peers that have come and gone, and of the clients that have gone.
  bool TellOfConnections();
  /// Tells that it goes on, after what else there is to tell.
  bool TellOfResume();
  /// What has changed before a start only the peers are told of: what clients had set going ended
  /// when it did.
  bool TellBeforeStartup();
  /// Runs what takes the place of commands that were not renewed by `now`.
  void EndExpired(SteadyTime now);
  /// When the next one must be renewed; the largest time where none must.
  [[nodiscard]] SteadyTime next_expiry() const noexcept;

  /// In the thread of a manager: there is something to tell.
  virtual void HearOfPeer(RequiredInterface& interface);
  virtual void HearOfGoneClient(GoneClient client);
  void KeepGoneClient(GoneClient client);

  /// Runs one of the author's functions; an exception faults the component, named after `where`,
  /// which is looked at then.
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
  /// Where a fault is that a command or event handler has thrown.
  static constexpr const char* kInHandler = "a command or event handler";
  /// One of its handlers has thrown in a thread of somebody else: this one. Only said in the log
  /// where it is not running.
  virtual void FaultFromOutside(const std::string& reason);
  void SetState(ComponentState state);

  ProvidedInterface& AddReservedInterface(PlacedName name);
  [[nodiscard]] Inbox* inbox() const { return inbox_.get(); }

 private:
  // Beside the functions above a base class has no names that an author's own could mean.

  Result<void> WaitForState(ComponentState wanted, Patience patience, bool ends_with_a_stop);
  bool TellOfPeers(RequiredInterface& interface);
  bool TellOfGoneClient(const GoneClient& client);

  std::string name_;
  Host host_{Host::Listeners{
      .on_exception = [this](const std::string& reason) { FaultFromOutside(reason); },
      .on_peer_changed = [this](RequiredInterface& interface) { HearOfPeer(interface); },
      .on_client_gone = [this](GoneClient client) { HearOfGoneClient(std::move(client)); }}};
  std::unique_ptr<Inbox> inbox_;
  bool sealed_ = false;
  std::vector<std::unique_ptr<ProvidedInterface>> provided_;
  std::vector<std::unique_ptr<RequiredInterface>> required_;
  std::map<std::string, SourcePlace> added_at_;
  std::vector<Expiry*> expiries_;
  NoticeList<GoneClient> gone_clients_;
  Published<ComponentState> state_{ComponentState::kConstructed};
  Flag is_starting_;
  Flag is_stopping_;
  mutable std::mutex mutex_;  // of fault_, its time and observer_, and of changes of the state
  std::condition_variable changed_;
  std::string fault_;
  std::chrono::system_clock::time_point fault_time_;
  std::function<void()> observer_;
};

}  // namespace tendon
