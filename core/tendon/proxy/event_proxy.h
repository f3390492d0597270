#pragma once

#include <tendon/interface/event.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/proxy/connection_messages.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tendon {

/// Represents an event of another process. It is raised here with encoded values.
class EventProxy final : public EventBase {
 public:
  /// Calls the handlers. lost() counts a value that a handler refuses. One thread at a time.
  void Raise(std::span<const std::byte> value) {
    CountLost();
    const std::uint64_t before = lost();
    CallHandlers([&](CommandBase& handler) {
      BytesSink nothing(nothing_);
      return handler.ExecuteEncoded(value, nothing);
    });
    lost_here_.Add(lost() - before);
  }

  /// Sets the total number of events that the other process could not send. CountLost() adds these
  /// events to the counts of the handlers. Called in the thread of Raise() or in one other thread.
  void SetLostThere(std::uint64_t lost) {
    const std::uint64_t before = lost_there_.Get();
    const std::uint64_t most = counted_there_.value() + message::EventsLost::kMaxAtOnce;
    lost_there_.Set(std::clamp(lost, before, std::max(before, most)));
  }
  /// Counts an event that has arrived but is not raised. May be called in the threads of
  /// SetLostThere().
  void Miss() noexcept { missed_.Add(); }
  /// Adds the lost events to the counts of the handlers. While there is no handler, does nothing.
  /// Must be called in the thread of Raise().
  void CountLost() {
    CountUpTo(lost_there_.Get(), counted_there_);
    CountUpTo(missed_.value(), counted_missed_);
  }
  /// Number of events that have arrived here, but did not reach a handler. May be called in any
  /// thread.
  [[nodiscard]] std::uint64_t lost_here() const noexcept {
    return lost_here_.value() + missed_.value();
  }

  /// Handlers are called with encoded values.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

 private:
  /// Counts lost events until `counted` is `lost_before`. If there are no handlers, the events are
  /// counted later.
  void CountUpTo(std::uint64_t lost_before, Counter<>& counted) {
    for (; counted.value() < lost_before; counted.Add()) {
      const std::uint64_t before = lost();
      CallHandlers([](CommandBase& /*it misses one*/) -> Status { return Status::kQueueFull; });
      if (lost() == before) return;
    }
  }

  std::vector<std::byte> nothing_;
  Published<std::uint64_t> lost_there_;
  Counter<> counted_there_;  // the part of lost_there_ that the handlers have counted
  Counter<> missed_;
  Counter<> counted_missed_;
  Counter<> lost_here_;
};

}  // namespace tendon
