#pragma once

#include <tendon/base/name.h>
#include <tendon/base/source_location.h>
#include <tendon/interface/event_waiter.h>
#include <tendon/interface/execution/command_function.h>
#include <tendon/interface/execution/member_names.h>
#include <tendon/interface/execution/thread_safe.h>
#include <tendon/interface/function.h>
#include <tendon/interface/inbox.h>
#include <tendon/interface/offer.h>
#include <tendon/lockfree/counter.h>

#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tendon {

enum class Need { kRequired, kOptional };

/// A named set of functions and event handlers that a component needs. A connection binds them to a
/// provided interface. Members are added in the component's constructor, as in ProvidedInterface.
class RequiredInterface {
 public:
  /// Events are queued in `inbox`. `inbox` is null if the component has no thread; then handlers
  /// run in the thread that raises the event, and any thread may call the functions. If `component`
  /// is null, handlers always run.
  RequiredInterface(std::string name, Inbox* inbox, Need need = Need::kRequired,
                    const ComponentAccess* component = nullptr)
      : name_(std::move(name)), inbox_(inbox), component_(component), need_(need) {
    SetCallers(inbox == nullptr ? CallerThreads::kManyThreads : CallerThreads::kOneThread);
  }
  RequiredInterface(const RequiredInterface&) = delete;
  RequiredInterface& operator=(const RequiredInterface&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

  /// Binds `function`, a member of the component, to the command of this name.
  template <CommandKind kKind, typename In, typename Out>
  void AddFunction(Function<kKind, In, Out>& function, LocatedName name,
                   Need need = Need::kRequired) {
    if constexpr (Payload<In> && Payload<Out>) {
      MemberDescription description = DescribeMember<In, Out>(std::move(name.text), kKind);
      description.optional = need == Need::kOptional;
      function.index_ = AddCaller(function, std::move(description), name.location);
      function.binding_ = &binding_;
    }
  }

  // Handlers whose events are queued until the component's thread handles them in
  // ProcessQueuedCommands(). A handler is a method and its object, or a lambda or another function
  // alone; command_function.h lists the forms that a function may have.

  template <typename Method, typename Object>
  Offer& AddEventHandlerVoid(Method method, Object* object, LocatedName name,
                             Need need = Need::kRequired) {
    return AddQueued<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name),
                                         need);
  }
  template <typename Callable>
  Offer& AddEventHandlerVoid(Callable function, LocatedName name, Need need = Need::kRequired) {
    return AddQueued<CommandKind::kVoid>(std::move(function), std::move(name), need);
  }
  template <typename Method, typename Object>
  Offer& AddEventHandlerWrite(Method method, Object* object, LocatedName name,
                              Need need = Need::kRequired) {
    return AddQueued<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name),
                                          need);
  }
  template <typename Callable>
  Offer& AddEventHandlerWrite(Callable function, LocatedName name, Need need = Need::kRequired) {
    return AddQueued<CommandKind::kWrite>(std::move(function), std::move(name), need);
  }

  // Handlers that run in the thread that raises the event; the tag kThreadSafe confirms that the
  // function allows it.

  template <typename Method, typename Object>
  void AddEventHandlerVoid(Method method, Object* object, LocatedName name, ThreadSafe,
                           Need need = Need::kRequired) {
    AddDirect<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name), need);
  }
  template <typename Callable>
  void AddEventHandlerVoid(Callable function, LocatedName name, ThreadSafe,
                           Need need = Need::kRequired) {
    AddDirect<CommandKind::kVoid>(std::move(function), std::move(name), need);
  }
  template <typename Method, typename Object>
  void AddEventHandlerWrite(Method method, Object* object, LocatedName name, ThreadSafe,
                            Need need = Need::kRequired) {
    AddDirect<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name), need);
  }
  template <typename Callable>
  void AddEventHandlerWrite(Callable function, LocatedName name, ThreadSafe,
                            Need need = Need::kRequired) {
    AddDirect<CommandKind::kWrite>(std::move(function), std::move(name), need);
  }

  // These forms select one of several methods that have the same name.

  template <typename Owner, std::derived_from<Owner> Object>
  Offer& AddEventHandlerVoid(void (Owner::*method)(), Object* object, LocatedName name,
                             Need need = Need::kRequired) {
    return AddQueued<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name),
                                         need);
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  Offer& AddEventHandlerWrite(void (Owner::*method)(Argument), Object* object, LocatedName name,
                              Need need = Need::kRequired) {
    return AddQueued<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name),
                                          need);
  }
  template <typename Owner, std::derived_from<Owner> Object>
  void AddEventHandlerVoid(void (Owner::*method)(), Object* object, LocatedName name, ThreadSafe,
                           Need need = Need::kRequired) {
    AddDirect<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name), need);
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  void AddEventHandlerWrite(void (Owner::*method)(Argument), Object* object, LocatedName name,
                            ThreadSafe, Need need = Need::kRequired) {
    AddDirect<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name), need);
  }

  /// Passes the events of this name to `waiter`, a member of the component, so that one thread of
  /// the component can wait for the events.
  template <Payload T>
  void AddEventWaiter(EventWaiter<T>& waiter, LocatedName name, Need need = Need::kRequired) {
    constexpr CommandKind kKind = std::same_as<T, None> ? CommandKind::kVoid : CommandKind::kWrite;
    AddOffer(std::make_unique<typename EventWaiter<T>::HandlerOffer>(
                 DescribeHandler<T>(kKind, std::move(name.text), need), waiter),
             name.location);
  }

  /// Sets the threads that call the functions of this interface. By default, only the task's own
  /// thread calls them. A constructor can allow other threads, such as callbacks of a driver.
  void SetCallers(CallerThreads callers) { binding_.SetCallers(callers, inbox_); }

  /// Sets the capacity of the mailbox for calls at the server, and of the mailbox for events here:
  /// 1 to 2^24, default 64. A call to another process waits here until it has been sent. Set the
  /// capacity before the connection is made.
  void SetMailboxCapacity(std::size_t capacity);

  /// Sets how long a read waits for the reply of another process: at least 1 ms, default 100 ms.
  /// Set it before the connection is made.
  void SetReadDeadline(std::chrono::milliseconds deadline);

  /// Makes reads of `function` return a local copy if the server is in another process. The copy is
  /// updated about 50 times a second. `function` must already be added.
  ///
  /// A read does not wait or lock, and allocates only the first time. It returns kNoSample before
  /// the first copy arrives. Function::age() returns the age of the copy.
  ///
  /// Within one process, Mirror() has no effect. In another process, the command must come from
  /// AddCommandReadState() without a delay; a connection to any other command is refused.
  template <Payload T>
  void Mirror(const Function<CommandKind::kRead, None, T>& function) {
    MarkMirrored(function);
  }

  /// Returns the time, on the steady clock, at which the present event was raised: the event that
  /// the component's thread is handling or has handled last. For an event of another process,
  /// returns the time of its arrival. Not for direct handlers, which run when the event is raised.
  [[nodiscard]] SteadyTime event_time() const { return event_time_; }
  /// Number of events that did not reach their handlers, because the mailbox was full, the
  /// component was not active, or a handler threw. If a handler keeps only the latest event, a
  /// replaced event does not count as lost.
  [[nodiscard]] std::uint64_t lost_events() const noexcept { return lost_events_.value(); }

  /// True if there is a connection. Functions reach the peer only after Component::OnConnected().
  [[nodiscard]] bool is_connected() const noexcept { return peer_.Get() != kNoPeer; }
  /// Returns a number that increases with each new peer, at Component::OnConnected(); 0 before the
  /// first peer. If the number has changed, earlier data came from another peer. Any thread.
  [[nodiscard]] std::uint64_t generation() const noexcept { return generation_.Get(); }

  // For managers, connections and proxies.

  /// Adds a function that is created at run time. Returns the index of `caller` in the binding.
  std::size_t AddCaller(MemberCaller& caller, MemberDescription description,
                        SourceLocation location = SourceLocation::current());
  Offer& AddOffer(std::unique_ptr<Offer> handler,
                  SourceLocation location = SourceLocation::current());
  [[nodiscard]] BindingGate& binding() { return binding_; }
  /// From now on, a handler with the name of a command observes this command: it gets each call as
  /// an encoded event; see DescribeCalls(). Such handlers must accept encoded values.
  void ObserveCalls() { observes_calls_ = true; }
  [[nodiscard]] bool observes_calls() const { return observes_calls_; }

  [[nodiscard]] Inbox* inbox() const { return inbox_; }
  [[nodiscard]] CallerThreads callers() const { return binding_.callers(); }
  [[nodiscard]] std::size_t mailbox_capacity() const { return mailbox_capacity_; }
  [[nodiscard]] std::chrono::milliseconds read_deadline() const { return read_deadline_; }
  /// Names of the mirrored functions.
  [[nodiscard]] std::vector<std::string> mirrored() const;
  [[nodiscard]] RequiredDescription description() const;
  /// True if some event handlers run in the thread that raises the event, which may take long.
  [[nodiscard]] bool handles_in_raiser() const;
  /// Names of the event handlers that keep only the latest event.
  [[nodiscard]] std::vector<std::string> latest_only() const;
  /// From now on, no member can be added.
  void Seal();

  // For the component's own thread, which handles each change of the peer before it continues.

  enum class PeerChange { kNone, kGone, kNew };
  [[nodiscard]] PeerChange peer_change() const noexcept {
    const std::uint64_t peer = peer_.Get();
    if (peer == reported_peer_) return PeerChange::kNone;
    return reported_peer_ != kNoPeer ? PeerChange::kGone : PeerChange::kNew;
  }
  /// Called when the component has handled kGone.
  void ForgetPeer() noexcept { reported_peer_ = kNoPeer; }
  /// Called after kNew. Starts the next generation. Returns false if the peer has been disconnected
  /// in between.
  bool TakePeer() noexcept;
  /// From now on, calls reach the peer and its events are handled. Does nothing if the peer has
  /// been disconnected.
  void AdmitPeer() noexcept;

  /// Like AdmitPeer(), but called by a manager while the component does not run. OnConnected() is
  /// called when the component starts. Does nothing if many threads may call the functions.
  void AdmitPeerAtRest() noexcept;

 private:
  friend class Connection;

  /// The data about a connection that the component uses.
  struct Peer {
    const BoundMember* members = nullptr;
    Mailbox* events = nullptr;
    std::uint64_t number = kNoPeer;
  };
  static constexpr std::uint64_t kNoPeer = 0;

  // For connections, in a manager's thread.

  /// True if the component is notified of its peers and admits them itself.
  [[nodiscard]] bool has_listener() const {
    return component_ != nullptr && component_->is_notified_of_connections();
  }
  /// Sets the peer and gives it a number. `peer` must stay valid until Withdraw().
  void Announce(Peer& peer);
  /// Removes the peer. When this function returns, no call reaches the peer.
  void Withdraw() noexcept;
  /// Notifies the component that it has lost its peer.
  void AnnounceNone();

  struct NamedCaller {
    MemberDescription description;
    MemberCaller* caller;
    bool is_mirrored = false;
  };

  void MarkMirrored(const MemberCaller& function);

  template <Payload In>
  static MemberDescription DescribeHandler(CommandKind kind, std::string name, Need need) {
    MemberDescription description = DescribeMember<In, None>(std::move(name), kind);
    description.optional = need == Need::kOptional;
    return description;
  }
  template <CommandKind kKind, typename Callable>
  Offer& AddQueued(Callable function, LocatedName name, Need need) {
    using In = typename callable::Traits<Callable>::In;
    static_assert(RequireCommandFunction<Callable, kKind>());
    if constexpr (CommandFunction<Callable, kKind>) {
      using Handler = callable::Handler<Callable>;
      return AddOffer(
          std::make_unique<QueuedOffer<In, None, Handler>>(
              DescribeHandler<In>(kKind, std::move(name.text), need), Handler(std::move(function))),
          name.location);
    } else {
      std::abort();
    }
  }
  template <CommandKind kKind, typename Callable>
  void AddDirect(Callable function, LocatedName name, Need need) {
    using In = typename callable::Traits<Callable>::In;
    static_assert(RequireCommandFunction<Callable, kKind>());
    if constexpr (CommandFunction<Callable, kKind>) {
      using Body = callable::DirectHandler<Callable>;
      AddOffer(std::make_unique<DirectOffer<In, None, Body>>(
                   DescribeHandler<In>(kKind, std::move(name.text), need),
                   Body(std::move(function)), ExceptionPolicy::kComponent),
               name.location);
    }
  }

  static constexpr std::size_t kDefaultCapacity = 64;
  static constexpr std::chrono::milliseconds kDefaultReadDeadline{100};

  std::string name_;
  Inbox* inbox_;
  const ComponentAccess* component_;
  Need need_;
  bool observes_calls_ = false;
  MemberNames names_;
  std::size_t mailbox_capacity_ = kDefaultCapacity;
  std::chrono::milliseconds read_deadline_ = kDefaultReadDeadline;
  std::vector<NamedCaller> callers_;
  std::vector<std::unique_ptr<Offer>> handlers_;
  BindingGate binding_;
  std::uint64_t peers_ = 0;  // number of peers so far
  Published<std::uint64_t> peer_{kNoPeer};
  GuardedPointer<const Peer> announced_;
  std::uint64_t reported_peer_ = kNoPeer;  // the peer that the component knows; used by its thread
  Published<std::uint64_t> generation_{0};
  SteadyTime event_time_{};  // used by the component's thread
  SharedCounter<> lost_events_;
};

}  // namespace tendon
