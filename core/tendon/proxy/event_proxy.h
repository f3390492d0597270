#pragma once

#include <tendon/interface/event.h>
#include <tendon/lockfree/counter.h>
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
    CountLostThere();
    const std::uint64_t before = lost();
    CallHandlers([&](CommandBase& handler) {
      BytesSink nothing(nothing_);
      return handler.ExecuteEncoded(value, nothing);
    });
    lost_here_.Add(lost() - before);
  }

  /// By whom raises it: the other process could not send so many, ever since. They have not reached
  /// the handlers, and are counted as that, as soon as there are any.
  void SetLostThere(std::uint64_t lost) {
    const std::uint64_t most = counted_there_ + message::EventsLost::kMostAtOnce;
    lost_there_ = std::clamp(lost, lost_there_, std::max(lost_there_, most));
    CountLostThere();
  }
  /// Any thread: how many have arrived here and have not reached a handler.
  [[nodiscard]] std::uint64_t lost_here() const noexcept { return lost_here_.value(); }

  /// Handlers are called by their encoded face.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

 private:
  /// Those told of before there were handlers wait for what comes next.
  void CountLostThere() {
    for (; counted_there_ < lost_there_; ++counted_there_) {
      const std::uint64_t before = lost();
      CallHandlers([](CommandBase& /*it misses one*/) -> Status { return Status::kQueueFull; });
      if (lost() == before) return;
    }
  }

  std::vector<std::byte> nothing_;
  std::uint64_t lost_there_ = 0;     // of whom raises it
  std::uint64_t counted_there_ = 0;  // likewise: those of them that handlers know of
  Counter<> lost_here_;
};

}  // namespace tendon
