#pragma once

#include <tendon/interface/caller.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/guarded_pointer.h>

#include <memory>
#include <mutex>
#include <vector>

namespace tendon {

/// The handlers of an event, whatever its type. One thread raises; managers subscribe at any time.
class EventBase : public Caller {
 public:
  ~EventBase() override;

  /// From now on `handler` is called, through a converting command where it needs one. It must
  /// outlive its Unsubscribe().
  void Subscribe(CommandBase& handler);
  /// After it returns the handler is not called any more, nor being called.
  void Unsubscribe(CommandBase& handler);

  /// How often a handler's mailbox was full, over all handlers.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.value(); }

 protected:
  struct Subscriber {
    CommandBase* handler = nullptr;
    std::shared_ptr<CommandBase> adapter;
    [[nodiscard]] CommandBase& target() const { return adapter ? *adapter : *handler; }
  };
  using List = std::vector<Subscriber>;

  GuardedPointer<List> current_;
  Counter<> lost_;

 private:
  void Replace(std::unique_ptr<List> next);

  std::mutex mutex_;  // of managers
  std::unique_ptr<List> list_;
};

/// Something that happens in a component, told to every handler that is connected. Raise it by
/// calling it, from the component's thread: it never waits, locks or allocates; a handler whose
/// mailbox is full misses it, which is counted.
template <Payload T>
class Event final : public EventBase {
 public:
  void operator()() requires std::is_same_v<T, None> { Raise(None{}); }
  void operator()(const T& value) requires(!std::is_same_v<T, None>) { Raise(value); }

  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    return AdaptByLayout<T, None>(command);
  }

 private:
  void Raise(const T& value) {
    const GuardedPointer<List>::Call call(current_);
    if (call.get() == nullptr) return;
    None nothing;
    for (const Subscriber& subscriber : *call.get()) {
      auto& handler = static_cast<Command<T, None>&>(subscriber.target());
      if (!handler.Execute(value, nothing)) lost_.Add();
    }
  }
};

using VoidEvent = Event<None>;
template <Payload T>
using WriteEvent = Event<T>;

}  // namespace tendon
