#pragma once

#include <tendon/interface/execution/member_caller.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace tendon {

/// The base class of Event, which authors use. It holds the handlers of an event of any type. One
/// thread raises the event, or many threads if the component has no thread of its own. Managers
/// subscribe handlers at any time.
class EventBase : public MemberCaller {
 public:
  ~EventBase() override;

  /// Adds a handler for all later events. If the layouts differ, it is called through a converting
  /// command. `lost` also counts the events that do not reach `handler`. `handler` and `lost` must
  /// live until Unsubscribe() returns.
  void Subscribe(CommandBase& handler, SharedCounter<>* lost = nullptr);
  /// Removes a handler. When this function returns, the handler does not run and is not called
  /// again.
  void Unsubscribe(CommandBase& handler);

  /// Notifies the handlers that the source of the event has faulted, or that it works again. Called
  /// by a thread that may raise the event.
  void SetSourceFaulted(bool faulted);

  /// Number of times that the event did not reach a handler, summed over all handlers. The reason
  /// is a full mailbox, a component that was not active, or a handler that threw.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

  /// Raising a disabled event does nothing. Any thread.
  void Enable() noexcept { enabled_.Set(true); }
  void Disable() noexcept { enabled_.Set(false); }
  [[nodiscard]] bool is_enabled() const noexcept { return enabled_.Get(); }

  /// Sets the threads that raise the event; see Gate. Called before the first event is raised.
  void SetRaisers(CallerThreads raisers, const Inbox* home) { current_.SetCallers(raisers, home); }

 protected:
  /// A connected handler. If its type has a different layout, `adapter` converts the value.
  struct Subscriber {
    CommandBase* handler = nullptr;
    std::shared_ptr<CommandBase> adapter;
    SharedCounter<>* lost = nullptr;  // counter of the component that handles the event
    [[nodiscard]] CommandBase& target() const { return adapter ? *adapter : *handler; }
  };
  using List = std::vector<Subscriber>;

  /// Called in a manager's thread, one at a time, after the list of handlers has changed.
  virtual void OnSubscribersChanged(bool /*has_subscribers*/) {}

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
  std::mutex mutex_;  // locked only by managers
  std::unique_ptr<List> list_;
};

}  // namespace tendon
