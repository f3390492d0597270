#pragma once

#include <tendon/interface/event.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/proxy/messages.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon {

/// An event of another process, raised here with encoded values.
class EventProxy final : public EventBase {
 public:
  /// From one thread at a time. A handler that refuses the value is counted in lost().
  void Raise(std::span<const std::byte> value) {
    CountLost();
    const std::uint64_t before = lost();
    CallHandlers([&](CommandBase& handler) {
      BytesSink nothing(nothing_);
      return handler.ExecuteEncoded(value, nothing);
    });
    lost_here_.Add(lost() - before);
  }

  /// By whom raises it, or one other thread: the other process could not send so many, ever since.
  /// They have not reached the handlers, and are counted as that by CountLost().
  void SetLostThere(std::uint64_t lost) {
    const std::uint64_t before = lost_there_.Get();
    const std::uint64_t most = counted_there_.value() + message::EventsLost::kMostAtOnce;
    lost_there_.Set(std::clamp(lost, before, std::max(before, most)));
  }
  /// Likewise: one that has arrived is not raised.
  void Miss() noexcept { missed_.Add(); }
  /// By whom raises it: tells the handlers of those that did not reach them, as soon as there are
  /// any.
  void CountLost() {
    CountUpTo(lost_there_.Get(), counted_there_);
    CountUpTo(missed_.value(), counted_missed_);
  }
  /// Any thread: how many have arrived here and have not reached a handler.
  [[nodiscard]] std::uint64_t lost_here() const noexcept {
    return lost_here_.value() + missed_.value();
  }

  /// Handlers are called by their encoded face.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

 private:
  /// Those told of before there were handlers wait for what comes next.
  void CountUpTo(std::uint64_t lost_before, Counter<>& counted) {
    for (; counted.value() < lost_before; counted.Add()) {
      const std::uint64_t before = lost();
      CallHandlers([](CommandBase& /*it misses one*/) -> Status { return Status::kQueueFull; });
      if (lost() == before) return;
    }
  }

  std::vector<std::byte> nothing_;
  Published<std::uint64_t> lost_there_;
  Counter<> counted_there_;  // those of them that handlers know of
  Counter<> missed_;
  Counter<> counted_missed_;
  Counter<> lost_here_;
};

}  // namespace tendon
