#pragma once

#include <tendon/interface/event.h>
#include <tendon/lockfree/counter.h>

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
    CallHandlers([&](CommandBase& handler) { return handler.ExecuteEncoded(value, nothing_); });
  }

  /// By whom raises it: the other process could not send so many, ever since. They have not reached
  /// the handlers, and are counted as that.
  void SetLostThere(std::uint64_t lost) {
    constexpr std::uint64_t kMostAtOnce = 65536;  // it takes a while, and a stranger says it
    const std::uint64_t known = lost_there_.value();
    const std::uint64_t news = std::min(lost - std::min(known, lost), kMostAtOnce);
    lost_there_.Add(news);
    for (std::uint64_t i = 0; i < news; ++i) {
      CallHandlers([](CommandBase& /*it misses one*/) -> Status { return Status::kQueueFull; });
    }
  }
  /// Any thread: how many have arrived here and have not reached a handler.
  [[nodiscard]] std::uint64_t lost_here() const noexcept {
    const std::uint64_t there = lost_there_.value();
    return std::max(lost(), there) - there;
  }

  /// Handlers are called by their encoded face.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

 private:
  std::vector<std::byte> nothing_;
  Counter<> lost_there_;
};

}  // namespace tendon
