#pragma once

#include <tendon/interface/execution/caller.h>
#include <tendon/lockfree/counter.h>

#include <memory>
#include <mutex>
#include <vector>

namespace tendon {

/// The handlers of an event, whatever its type. One thread raises, or many where the component has
/// none of its own; managers subscribe at any time.
class EventBase : public Caller {
 public:
  ~EventBase() override;

  /// From now on `handler` is called, through a converting command where it needs one; what does
  /// not reach it is counted in `lost` as well. Both must outlive its Unsubscribe().
  void Subscribe(CommandBase& handler, SharedCounter<>* lost = nullptr);
  /// After it returns the handler is not called any more, nor being called.
  void Unsubscribe(CommandBase& handler);

  /// Tells the handlers that nobody will raise it until further notice, or no longer. By whom may
  /// raise it.
  void SetSourceFaulted(bool faulted);

  /// How often it has not reached a handler, over all of them: its mailbox was full, its component
  /// not active, or it threw.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

  /// While it is off, raising it does nothing. Any thread.
  void Enable() noexcept { enabled_.Set(true); }
  void Disable() noexcept { enabled_.Set(false); }
  [[nodiscard]] bool is_enabled() const noexcept { return enabled_.Get(); }

  /// Before it is raised; see Gate.
  void SetRaisers(Callers raisers, const Inbox* home) { current_.SetCallers(raisers, home); }

 protected:
  /// A connected handler; `adapter` converts for one whose type has another layout.
  struct Subscriber {
    CommandBase* handler = nullptr;
    std::shared_ptr<CommandBase> adapter;
    SharedCounter<>* lost = nullptr;  // of the component that handles it
    [[nodiscard]] CommandBase& target() const { return adapter ? *adapter : *handler; }
  };
  using List = std::vector<Subscriber>;

  /// `call(CommandBase&) -> Status` for each handler; a failed one is counted as lost.
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
  std::mutex mutex_;  // of managers
  std::unique_ptr<List> list_;
};

/// Something that happens in a component, told to every handler that is connected. Raise it by
/// calling it, from the component's thread: it never waits, locks or allocates; a handler whose
/// mailbox is full misses it, which is counted at both ends. Handlers that run directly run in this
/// thread.
template <typename T>
class Event final : public EventBase {
  static_assert(RequirePayload<T>());

 public:
  void operator()() requires std::is_same_v<T, None> { Raise(None{}); }
  void operator()(const T& value) requires(!std::is_same_v<T, None>) { Raise(value); }

  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    return AdaptByLayout<T, None>(command);
  }

 private:
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
