#pragma once

#include <tendon/interface/event.h>

#include <cstddef>
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

  /// Handlers are called by their encoded face.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

 private:
  std::vector<std::byte> nothing_;
};

}  // namespace tendon
