#pragma once

#include <tendon/interface/required_interface.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

/// A function that was made at run time, from its description, and calls with encoded values: for
/// another process, a console, a script.
class FunctionProxy final : public Caller {
 public:
  /// Adds itself to `interface`, which must live as long as it is called. ConfigurationError as for
  /// any member.
  FunctionProxy(RequiredInterface& interface, MemberDescription description)
      : kind_(description.signature.kind),
        index_(interface.AddCaller(*this, std::move(description))),
        binding_(interface.binding()) {}

  [[nodiscard]] CommandKind kind() const { return kind_; }

  /// All functions of an interface by one thread at a time. `out` is replaced.
  Status operator()(std::span<const std::byte> in, std::vector<std::byte>& out) {
    out.clear();
    const BindingPointer::Call call(binding_);
    if (call.get() == nullptr) return Status::kNotConnected;
    CommandBase* command = call.get()->commands[index_];
    return command != nullptr ? command->ExecuteEncoded(in, out) : Status::kNotConnected;
  }

  /// Commands are called by their encoded face.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*command*/) const override {
    return nullptr;
  }

 private:
  CommandKind kind_;
  std::size_t index_;
  BindingPointer& binding_;
};

/// Whether a call of it waits in a mailbox.
[[nodiscard]] constexpr bool IsQueued(CommandKind kind) {
  return kind == CommandKind::kVoid || kind == CommandKind::kWrite;
}

}  // namespace tendon
