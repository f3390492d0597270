#pragma once

#include <tendon/base/name.h>
#include <tendon/base/source_location.h>
#include <tendon/interface/event.h>
#include <tendon/interface/execution/member_names.h>
#include <tendon/interface/execution/scratch.h>
#include <tendon/interface/execution/shared_read_command.h>
#include <tendon/interface/execution/thread_safe.h>
#include <tendon/interface/inbox.h>
#include <tendon/interface/offer.h>
#include <tendon/state/state_table.h>

#include <concepts>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace tendon {

/// A named set of commands and events that a component offers.
///
/// Fill it in the component's constructor. A function that adds a member throws ConfigurationError
/// if the name is a duplicate or invalid, or if the component was already started. Events and the
/// objects of methods must outlive the interface; use members of the component.
class ProvidedInterface {
 public:
  /// Calls are queued in `inbox` for the component's thread. If `inbox` is null, calls run in the
  /// caller's thread. If `component` is null, calls are always accepted.
  ProvidedInterface(std::string name, Inbox* inbox, const ComponentAccess* component = nullptr)
      : name_(std::move(name)), inbox_(inbox), component_(component) {}
  ProvidedInterface(const ProvidedInterface&) = delete;
  ProvidedInterface& operator=(const ProvidedInterface&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }

  // Commands whose calls are queued until the component's thread executes them in
  // ProcessQueuedCommands().

  template <typename Owner, std::derived_from<Owner> Object>
  Offer& AddCommandVoid(void (Owner::*method)(), Object* object, LocatedName name) {
    return AddQueued<None, None>(CommandKind::kVoid, std::move(name),
                                 [method, object](const None&, None&) { (object->*method)(); });
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  Offer& AddCommandWrite(void (Owner::*method)(Argument), Object* object, LocatedName name) {
    using In = std::remove_cvref_t<Argument>;
    return AddQueued<In, None>(CommandKind::kWrite, std::move(name),
                               [method, object](const In& in, None&) { (object->*method)(in); });
  }
  /// Adds a command whose caller waits for the reply until a deadline. Use it only for quick
  /// methods, because a reply after the deadline is lost.
  template <typename Owner, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandVoidReturn(void (Owner::*method)(Out&), Object* object, LocatedName name) {
    return AddQueued<None, Out>(
        CommandKind::kVoidReturn, std::move(name),
        [method, object](const None&, Out& out) { (object->*method)(out); });
  }
  template <typename Owner, typename Argument, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandWriteReturn(void (Owner::*method)(Argument, Out&), Object* object,
                               LocatedName name) {
    using In = std::remove_cvref_t<Argument>;
    return AddQueued<In, Out>(
        CommandKind::kWriteReturn, std::move(name),
        [method, object](const In& in, Out& out) { (object->*method)(in, out); });
  }
  /// Adds a write command with the argument type `In`. `filter(in, filtered)` runs in the caller's
  /// thread, and `filtered` is queued. If `filter` throws, the caller gets kFailed.
  template <typename In, typename Filtered, typename Owner, typename Argument,
            std::derived_from<Owner> Object>
  Offer& AddCommandFilteredWrite(void (*filter)(const In&, Filtered&),
                                 void (Owner::*method)(Argument), Object* object,
                                 LocatedName name) {
    static_assert(RequirePayload<In>() && RequirePayload<Filtered>());
    const auto handler = [method, object](const Filtered& in, None&) { (object->*method)(in); };
    return AddOffer(
        std::make_unique<FilteredOffer<In, Filtered, decltype(filter), decltype(handler)>>(
            DescribeMember<In, None>(std::move(name.text), CommandKind::kWrite), filter, handler),
        name.location);
  }

  // Commands that run in the caller's thread and read only rows of a state table.

  /// Adds a read of the newest value in a column of `table`. The read returns kNoSample before the
  /// first row. It allocates nothing for payloads of fixed size.
  template <Payload T>
  Offer& AddCommandReadState(const StateTable& table, const T& variable, LocatedName name) {
    const Column<T>& column = table.Find(variable);
    return AddDirect<None, T>(CommandKind::kRead, std::move(name),
                              [&column](const None&, T& out) { return column.ReadNewest(out); })
        .SetSource({&table, &column})
        .SetReadsTableOnly();
  }
  /// Adds a read of the value that is `delay` rows older than the newest. The read returns
  /// kNoSample until this value exists, and always if the table is too short to keep the value.
  template <Payload T>
  Offer& AddCommandReadState(const StateTable& table, const T& variable, LocatedName name,
                             std::size_t delay) {
    const Column<T>& column = table.Find(variable);
    return AddDirect<None, T>(CommandKind::kRead, std::move(name),
                              [&column, delay](const None&, T& out) {
                                return ToStatus(column.ReadDelayed(delay, out));
                              })
        .SetReadsTableOnly();
  }
  /// Adds a read that runs `function(row, argument, result)` with the newest value of a column.
  template <Payload T, typename In, typename Out>
  Offer& AddCommandQualifiedRead(const StateTable& table, const T& variable,
                                 void (*function)(const T&, const In&, Out&), LocatedName name) {
    const Column<T>& column = table.Find(variable);
    return AddDirect<In, Out>(
        CommandKind::kQualifiedRead, std::move(name),
        [&column, function, scratch = Scratch<T>()](const In& in, Out& out) mutable -> Status {
          typename Scratch<T>::Use row(scratch);
          const Status status = column.ReadNewest(*row);
          if (status) function(*row, in, out);
          return status;
        });
  }

  // Commands that run in the caller's thread at any time; the tag ThreadSafe confirms that the
  // method allows it.

  template <typename Owner, std::derived_from<Owner> Object>
  Offer& AddCommandVoid(void (Owner::*method)(), Object* object, LocatedName name, ThreadSafe) {
    return AddDirect<None, None>(CommandKind::kVoid, std::move(name),
                                 CallMethod<None>(method, object));
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  Offer& AddCommandWrite(void (Owner::*method)(Argument), Object* object, LocatedName name,
                         ThreadSafe) {
    using In = std::remove_cvref_t<Argument>;
    return AddDirect<In, None>(CommandKind::kWrite, std::move(name),
                               CallMethod<In>(method, object));
  }
  template <typename Owner, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandRead(void (Owner::*method)(Out&) const, const Object* object, LocatedName name,
                        ThreadSafe) {
    return AddDirect<None, Out>(CommandKind::kRead, std::move(name),
                                [method, object](const None&, Out& out) -> Status {
                                  (object->*method)(out);
                                  return Status::kDone;
                                });
  }
  /// Adds a read of a value that never changes after the method has returned it, such as an image
  /// or a map. For another process, the value is encoded without copying it first; callers in this
  /// process get a copy. If the method returns null, the caller gets kNoSample. The method runs in
  /// the caller's thread. The last thread that uses the value frees it; this may be the caller's
  /// thread.
  template <typename Owner, Payload Out, std::derived_from<Owner> Object>
  Offer& AddCommandRead(std::shared_ptr<const Out> (Owner::*method)() const, const Object* object,
                        LocatedName name, ThreadSafe) {
    static_assert(RequirePayload<Out>());
    const auto body = [method, object] { return (object->*method)(); };
    return AddOffer(std::make_unique<SharedReadOffer<Out, decltype(body)>>(
                        DescribeMember<None, Out>(std::move(name.text), CommandKind::kRead), body),
                    name.location);
  }
  template <typename Owner, typename Argument, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandQualifiedRead(void (Owner::*method)(Argument, Out&) const, const Object* object,
                                 LocatedName name, ThreadSafe) {
    using In = std::remove_cvref_t<Argument>;
    return AddDirect<In, Out>(CommandKind::kQualifiedRead, std::move(name),
                              [method, object](const In& in, Out& out) -> Status {
                                (object->*method)(in, out);
                                return Status::kDone;
                              });
  }

  /// Lets clients handle `event`, which the component raises by calling `event`.
  template <Payload T>
  void AddEvent(Event<T>& event, LocatedName name) {
    constexpr CommandKind kKind = std::same_as<T, None> ? CommandKind::kVoid : CommandKind::kWrite;
    AddEvent(event, DescribeMember<T, None>(std::move(name.text), kKind), name.location);
  }

  // For managers, connections and proxies.

  /// Adds a command that is created at run time, such as a command of a proxy or a column of a
  /// table.
  Offer& AddOffer(std::unique_ptr<Offer> offer,
                  SourceLocation location = SourceLocation::current());
  void AddEvent(EventBase& event, MemberDescription description,
                SourceLocation location = SourceLocation::current());

  [[nodiscard]] Inbox* inbox() const { return inbox_; }
  [[nodiscard]] const ComponentAccess* component() const { return component_; }
  /// Returns the threads that raise the events of this interface: any thread if the component has
  /// no thread of its own.
  [[nodiscard]] CallerThreads raisers() const {
    return inbox_ == nullptr ? CallerThreads::kManyThreads : CallerThreads::kOneThread;
  }

  /// Null if there is no member with this name.
  [[nodiscard]] const Offer* FindCommand(const std::string& name) const;
  [[nodiscard]] EventBase* FindEvent(const std::string& name) const;
  /// Returns the event by which observers see the calls of a command. Null if there is no command
  /// with this name, or its calls cannot be observed.
  [[nodiscard]] EventBase* ObserveCalls(const std::string& name);

  /// Returns one Expiry for each command whose effect must be renewed.
  [[nodiscard]] std::vector<Expiry*> expiries() const;

  /// Calls EventBase::SetSourceFaulted() of all events of this interface.
  void SetSourceFaulted(bool faulted);

  [[nodiscard]] ProvidedDescription description() const;
  /// Like description(), but the events include the calls of the commands, for observers.
  [[nodiscard]] ProvidedDescription description_for_observers() const;
  /// Names of the commands that keep only the latest call.
  [[nodiscard]] std::vector<std::string> latest_only() const;

  /// From now on, no member can be added.
  void Seal() { names_.Seal(); }

 private:
  struct NamedEvent {
    MemberDescription description;
    EventBase* event;
  };

  template <typename In, typename Out, typename Handler>
  Offer& AddQueued(CommandKind kind, LocatedName name, Handler handler) {
    static_assert(RequirePayload<In>() && RequirePayload<Out>());
    return AddOffer(std::make_unique<QueuedOffer<In, Out, Handler>>(
                        DescribeMember<In, Out>(std::move(name.text), kind), std::move(handler)),
                    name.location);
  }
  template <typename In, typename Out, typename Body>
  Offer& AddDirect(CommandKind kind, LocatedName name, Body body) {
    static_assert(RequirePayload<In>() && RequirePayload<Out>());
    const bool asks = kind == CommandKind::kRead || kind == CommandKind::kQualifiedRead;
    return AddOffer(std::make_unique<DirectOffer<In, Out, Body>>(
                        DescribeMember<In, Out>(std::move(name.text), kind), std::move(body),
                        asks ? ExceptionPolicy::kCaller : ExceptionPolicy::kComponent),
                    name.location);
  }

  std::string name_;
  Inbox* inbox_;
  const ComponentAccess* component_;
  MemberNames names_;
  std::vector<std::unique_ptr<Offer>> commands_;
  std::vector<NamedEvent> events_;
};

}  // namespace tendon
