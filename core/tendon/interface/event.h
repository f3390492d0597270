#pragma once

#include <tendon/interface/event_base.h>

#include <memory>
#include <type_traits>

namespace tendon {

/// An event that a component raises by calling this object in its own thread. Each connected
/// handler is notified. Raising an event never waits, locks or allocates. If the mailbox of a
/// handler is full, the handler misses the event, and both components count the lost event. Direct
/// handlers run in the thread that raises the event.
template <typename T>
class Event final : public EventBase {
  static_assert(RequirePayload<T>());

 public:
  /// Raises the event.
  void operator()() requires std::is_same_v<T, None> { Raise(None{}); }
  void operator()(const T& value) requires(!std::is_same_v<T, None>) { Raise(value); }

 private:
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    if constexpr (Payload<T>) return AdaptByLayout<T, None>(command);
    return nullptr;
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
