#pragma once

#include <tendon/base/name.h>
#include <tendon/base/source_location.h>
#include <tendon/interface/event.h>
#include <tendon/interface/execution/command_function.h>
#include <tendon/interface/execution/member_names.h>
#include <tendon/interface/execution/scratch.h>
#include <tendon/interface/execution/shared_read_command.h>
#include <tendon/interface/execution/thread_safe.h>
#include <tendon/interface/inbox.h>
#include <tendon/interface/offer.h>
#include <tendon/state/state_table.h>

#include <concepts>
#include <cstddef>
#include <cstdlib>
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
  // ProcessQueuedCommands(). A command is a method and its object, or a lambda or another function
  // alone; command_function.h lists the forms that a function may have.

  template <typename Method, typename Object>
  Offer& AddCommandVoid(Method method, Object* object, LocatedName name) {
    return AddQueued<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Callable>
  Offer& AddCommandVoid(Callable function, LocatedName name) {
    return AddQueued<CommandKind::kVoid>(std::move(function), std::move(name));
  }
  template <typename Method, typename Object>
  Offer& AddCommandWrite(Method method, Object* object, LocatedName name) {
    return AddQueued<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Callable>
  Offer& AddCommandWrite(Callable function, LocatedName name) {
    return AddQueued<CommandKind::kWrite>(std::move(function), std::move(name));
  }
  /// Adds a command whose caller waits for the reply until a deadline. Use it only for quick
  /// functions, because a reply after the deadline is lost.
  template <typename Method, typename Object>
  Offer& AddCommandVoidReturn(Method method, Object* object, LocatedName name) {
    return AddQueued<CommandKind::kVoidReturn>(callable::BoundMethod{method, object},
                                               std::move(name));
  }
  template <typename Callable>
  Offer& AddCommandVoidReturn(Callable function, LocatedName name) {
    return AddQueued<CommandKind::kVoidReturn>(std::move(function), std::move(name));
  }
  template <typename Method, typename Object>
  Offer& AddCommandWriteReturn(Method method, Object* object, LocatedName name) {
    return AddQueued<CommandKind::kWriteReturn>(callable::BoundMethod{method, object},
                                                std::move(name));
  }
  template <typename Callable>
  Offer& AddCommandWriteReturn(Callable function, LocatedName name) {
    return AddQueued<CommandKind::kWriteReturn>(std::move(function), std::move(name));
  }
  /// Adds a write command with the argument of `filter`, a function of the form
  /// `void f(const In&, Filtered&)` or `Filtered f(const In&)` that captures nothing. `filter` runs
  /// in the caller's thread, and its result is queued. If `filter` throws, the caller gets kFailed.
  template <typename Filter, typename Method, typename Object>
  Offer& AddCommandFilteredWrite(Filter filter, Method method, Object* object, LocatedName name) {
    return AddFiltered(std::move(filter), callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Filter, typename Callable>
  Offer& AddCommandFilteredWrite(Filter filter, Callable function, LocatedName name) {
    return AddFiltered(std::move(filter), std::move(function), std::move(name));
  }

  // Commands that run in the caller's thread and read only rows of a state table.

  /// Adds a read of the newest value in a column of `table`. The read returns kNoSample before the
  /// first row. It allocates nothing for payloads of fixed size.
  template <Payload T>
  Offer& AddCommandReadState(const StateTable& table, const T& variable, LocatedName name) {
    const Column<T>& column = table.Find(variable);
    return AddBody<CommandKind::kRead, None, T>(
               std::move(name), [&column](const None&, T& out) { return column.ReadNewest(out); })
        .SetSource({&table, &column})
        .SetReadsTableOnly();
  }
  /// Adds a read of the value that is `delay` rows older than the newest. The read returns
  /// kNoSample until this value exists, and always if the table is too short to keep the value.
  template <Payload T>
  Offer& AddCommandReadState(const StateTable& table, const T& variable, LocatedName name,
                             std::size_t delay) {
    const Column<T>& column = table.Find(variable);
    return AddBody<CommandKind::kRead, None, T>(std::move(name),
                                                [&column, delay](const None&, T& out) {
                                                  return ToStatus(column.ReadDelayed(delay, out));
                                                })
        .SetReadsTableOnly();
  }
  /// Adds a read that runs `function(row, argument, result)` with the newest value of a column.
  /// `function` runs in the caller's thread, so it must be a free function or a lambda that
  /// captures nothing.
  template <Payload T, typename Callable>
  Offer& AddCommandQualifiedRead(const StateTable& table, const T& variable, Callable function,
                                 LocatedName name) {
    using Form = callable::Traits<Callable>;
    static_assert(RequireRowFunction<Callable, T>());
    if constexpr (RowFunction<Callable, T>) {
      const Column<T>& column = table.Find(variable);
      return AddBody<CommandKind::kQualifiedRead, typename Form::In, typename Form::Out>(
          std::move(name),
          [&column, handler = callable::Handler<Callable>(std::move(function)),
           scratch = Scratch<T>()](const auto& in, auto& out) mutable -> Status {
            typename Scratch<T>::Use row(scratch);
            const Status status = column.ReadNewest(*row);
            if (status) handler(*row, in, out);
            return status;
          });
    } else {
      std::abort();
    }
  }

  // Commands that run in the caller's thread at any time; the tag kThreadSafe confirms that the
  // function allows it.

  template <typename Method, typename Object>
  Offer& AddCommandVoid(Method method, Object* object, LocatedName name, ThreadSafe) {
    return AddDirect<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Callable>
  Offer& AddCommandVoid(Callable function, LocatedName name, ThreadSafe) {
    return AddDirect<CommandKind::kVoid>(std::move(function), std::move(name));
  }
  template <typename Method, typename Object>
  Offer& AddCommandWrite(Method method, Object* object, LocatedName name, ThreadSafe) {
    return AddDirect<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Callable>
  Offer& AddCommandWrite(Callable function, LocatedName name, ThreadSafe) {
    return AddDirect<CommandKind::kWrite>(std::move(function), std::move(name));
  }
  /// Adds a read. If the function returns a std::shared_ptr<const T>, the command reads a T, such
  /// as an image or a map, which must never change after the function has returned it. For another
  /// process, this value is encoded without copying it first; callers in this process get a copy.
  /// A function that returns a string or a list by value allocates memory in the caller's thread;
  /// with the form `void f(U&)`, the caller's memory is reused.
  /// If the function returns null, the caller gets kNoSample. The last thread that uses the value
  /// frees it; this may be the caller's thread.
  template <typename Method, typename Object, typename Tag = Untagged>
  Offer& AddCommandRead(Method method, Object* object, LocatedName name, Tag = {}) {
    static_assert(RequireThreadSafe<Tag>());
    return AddRead(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Callable, typename Tag = Untagged>
  Offer& AddCommandRead(Callable function, LocatedName name, Tag = {}) {
    static_assert(RequireThreadSafe<Tag>());
    return AddRead(std::move(function), std::move(name));
  }
  template <typename Method, typename Object, typename Tag = Untagged>
  Offer& AddCommandQualifiedRead(Method method, Object* object, LocatedName name, Tag = {}) {
    static_assert(RequireThreadSafe<Tag>());
    return AddDirect<CommandKind::kQualifiedRead>(callable::BoundMethod{method, object},
                                                  std::move(name));
  }
  template <typename Callable, typename Tag = Untagged>
  Offer& AddCommandQualifiedRead(Callable function, LocatedName name, Tag = {}) {
    static_assert(RequireThreadSafe<Tag>());
    return AddDirect<CommandKind::kQualifiedRead>(std::move(function), std::move(name));
  }

  // These forms select one of several methods or functions that have the same name.

  template <typename Owner, std::derived_from<Owner> Object>
  Offer& AddCommandVoid(void (Owner::*method)(), Object* object, LocatedName name) {
    return AddQueued<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  Offer& AddCommandWrite(void (Owner::*method)(Argument), Object* object, LocatedName name) {
    return AddQueued<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Owner, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandVoidReturn(void (Owner::*method)(Out&), Object* object, LocatedName name) {
    return AddQueued<CommandKind::kVoidReturn>(callable::BoundMethod{method, object},
                                               std::move(name));
  }
  template <typename Owner, typename Argument, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandWriteReturn(void (Owner::*method)(Argument, Out&), Object* object,
                               LocatedName name) {
    return AddQueued<CommandKind::kWriteReturn>(callable::BoundMethod{method, object},
                                                std::move(name));
  }
  template <typename In, typename Filtered, typename Owner, typename Argument,
            std::derived_from<Owner> Object>
  Offer& AddCommandFilteredWrite(void (*filter)(const In&, Filtered&),
                                 void (Owner::*method)(Argument), Object* object,
                                 LocatedName name) {
    return AddFiltered(filter, callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Owner, std::derived_from<Owner> Object>
  Offer& AddCommandVoid(void (Owner::*method)(), Object* object, LocatedName name, ThreadSafe) {
    return AddDirect<CommandKind::kVoid>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  Offer& AddCommandWrite(void (Owner::*method)(Argument), Object* object, LocatedName name,
                         ThreadSafe) {
    return AddDirect<CommandKind::kWrite>(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Owner, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandRead(void (Owner::*method)(Out&) const, const Object* object, LocatedName name,
                        ThreadSafe) {
    return AddRead(callable::BoundMethod{method, object}, std::move(name));
  }
  template <typename Owner, typename Argument, typename Out, std::derived_from<Owner> Object>
  Offer& AddCommandQualifiedRead(void (Owner::*method)(Argument, Out&) const, const Object* object,
                                 LocatedName name, ThreadSafe) {
    return AddDirect<CommandKind::kQualifiedRead>(callable::BoundMethod{method, object},
                                                  std::move(name));
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

  template <CommandKind kKind, typename Callable>
  Offer& AddQueued(Callable function, LocatedName name) {
    using Form = callable::Traits<Callable>;
    static_assert(RequireCommandFunction<Callable, kKind>());
    if constexpr (CommandFunction<Callable, kKind>) {
      using Handler = callable::Handler<Callable>;
      return AddOffer(
          std::make_unique<QueuedOffer<typename Form::In, typename Form::Out, Handler>>(
              DescribeMember<typename Form::In, typename Form::Out>(std::move(name.text), kKind),
              Handler(std::move(function))),
          name.location);
    } else {
      std::abort();
    }
  }
  template <typename Filter, typename Callable>
  Offer& AddFiltered(Filter filter, Callable function, LocatedName name) {
    using In = typename callable::Traits<Filter>::In;
    using Filtered = typename callable::Traits<Filter>::Out;
    static_assert(RequireFilter<Filter, Callable>());
    if constexpr (FilterFor<Filter, Callable>) {
      using Handler = callable::Handler<Callable>;
      using FilterHandler = callable::Handler<Filter>;
      return AddOffer(std::make_unique<FilteredOffer<In, Filtered, FilterHandler, Handler>>(
                          DescribeMember<In, None>(std::move(name.text), CommandKind::kWrite),
                          FilterHandler(std::move(filter)), Handler(std::move(function))),
                      name.location);
    } else {
      std::abort();
    }
  }
  template <CommandKind kKind, typename Callable>
  Offer& AddDirect(Callable function, LocatedName name) {
    using Form = callable::Traits<Callable>;
    static_assert(RequireCommandFunction<Callable, kKind>());
    if constexpr (CommandFunction<Callable, kKind>) {
      return AddBody<kKind, typename Form::In, typename Form::Out>(
          std::move(name), callable::DirectHandler<Callable>(std::move(function)));
    } else {
      std::abort();
    }
  }
  template <typename Callable>
  Offer& AddRead(Callable function, LocatedName name) {
    if constexpr (callable::SharedRead<Callable>) {
      using Out = typename callable::SharedValue<typename callable::Traits<Callable>::Out>::Type;
      using Body = callable::Handler<Callable>;
      static_assert(callable::RequireConst<Callable>() && RequirePayload<Out>());
      if constexpr (Payload<Out>) {
        return AddOffer(std::make_unique<SharedReadOffer<Out, Body>>(
                            DescribeMember<None, Out>(std::move(name.text), CommandKind::kRead),
                            Body(std::move(function))),
                        name.location);
      } else {
        std::abort();
      }
    } else {
      return AddDirect<CommandKind::kRead>(std::move(function), std::move(name));
    }
  }
  template <CommandKind kKind, typename In, typename Out, typename Body>
  Offer& AddBody(LocatedName name, Body body) {
    constexpr auto kPolicy =
        callable::IsRead(kKind) ? ExceptionPolicy::kCaller : ExceptionPolicy::kComponent;
    return AddOffer(
        std::make_unique<DirectOffer<In, Out, Body>>(
            DescribeMember<In, Out>(std::move(name.text), kKind), std::move(body), kPolicy),
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
