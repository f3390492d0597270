#pragma once

#include <tendon/interface/execution/member_caller.h>
#include <tendon/lockfree/counter.h>

#include <memory>
#include <mutex>
#include <vector>

namespace tendon {

/// The base of Event (below, for authors), whatever the type of the event: holds its handlers. One
/// thread raises the event, or many if the component has no thread of its own. Managers subscribe
/// handlers at any time.
class EventBase : public MemberCaller {
 public:
  ~EventBase() override;

  /// Calls `handler` from now on, through a converting command if needed. Events that do not reach
  /// `handler` are also counted in `lost`. Both must live until Unsubscribe() returns.
  void Subscribe(CommandBase& handler, SharedCounter<>* lost = nullptr);
  /// After the return, the handler does not run and is not called again.
  void Unsubscribe(CommandBase& handler);

  /// Notifies the handlers that the source of the event has faulted, or works again. Called by a
  /// thread that may raise the event.
  void SetSourceFaulted(bool faulted);

  /// Number of times that the event did not reach a handler, summed over all handlers: the mailbox
  /// was full, the component was not active, or the handler threw.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

  /// Raising a disabled event does nothing. Any thread.
  void Enable() noexcept { enabled_.Set(true); }
  void Disable() noexcept { enabled_.Set(false); }
  [[nodiscard]] bool is_enabled() const noexcept { return enabled_.Get(); }

  /// Called before the first event is raised; see Gate.
  void SetRaisers(CallerThreads raisers, const Inbox* home) { current_.SetCallers(raisers, home); }

 protected:
  /// A connected handler. `adapter` converts if its type has a different layout.
  struct Subscriber {
    CommandBase* handler = nullptr;
    std::shared_ptr<CommandBase> adapter;
    SharedCounter<>* lost = nullptr;  // counter of the handling component
    [[nodiscard]] CommandBase& target() const { return adapter ? *adapter : *handler; }
  };
  using List = std::vector<Subscriber>;

  /// Runs `call(CommandBase&) -> Status` for each handler and counts a failed call as lost.
  template <typename Call>
  void CallHandlers(Call call) {
    if (!is_enabled()) return;
    current_.Enter([&](const List* list) {
      if (list == nullptr) return;
      for (const Subscriber& subscriber : *list) {
        if (call(subscriber.target())) continue;
        lost_.Add();
        if (subscriber.lost != nullptr) subscriber.lost->Add();
      }
    });
  }

 private:
  void Replace(std::unique_ptr<List> next);

  Flag enabled_{true};
  Gate<List> current_;
  SharedCounter<> lost_;
  std::mutex mutex_;  // taken by managers only
  std::unique_ptr<List> list_;
};

/// An event that a component raises by calling this object in its own thread. All connected
/// handlers are notified. Raising never waits, locks or allocates. A handler whose mailbox is full
/// misses the event, and both ends count it. Direct handlers run in the thread that raises.
template <typename T>
class Event final : public EventBase {
  static_assert(RequirePayload<T>());

 public:
  /// Raises the event.
  void operator()() requires std::is_same_v<T, None> { Raise(None{}); }
  void operator()(const T& value) requires(!std::is_same_v<T, None>) { Raise(value); }

 private:
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    return AdaptByLayout<T, None>(command);
  }

  void Raise(const T& value) {
    CallHandlers([&value](CommandBase& handler) {
      None nothing;
      return static_cast<Command<T, None>&>(handler).Execute(value, nothing);
    });
  }
};

using VoidEvent = Event<None>;
template <typename T>
using WriteEvent = Event<T>;

}  // namespace tendon
