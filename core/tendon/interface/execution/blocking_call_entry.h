#pragma once

#include <tendon/interface/mailbox.h>

#include <cstddef>

namespace tendon {

/// The mailbox entry of `Command` for the calls whose callers wait. `Command` itself is the entry
/// for its other calls.
template <typename Command>
class BlockingCallEntry final : public Mailbox::Entry {
 public:
  explicit BlockingCallEntry(Command& command) : command_(command) {}

  void ExecuteSlot(std::byte* argument, std::size_t slot) override {
    command_.ExecuteBlockingCall(argument, slot);
  }
  void DropSlot(std::byte* argument, std::size_t slot) noexcept override {
    command_.DropBlockingCall(argument, slot);
  }

 private:
  Command& command_;
};

}  // namespace tendon
