#pragma once

#include <tendon/interface/required_interface.h>

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

/// A function of a required interface that is created at run time from its description and is
/// called with encoded values. It makes calls for another process, a console or a script.
class FunctionProxy final : public MemberCaller {
 public:
  /// Adds this function to `interface`, which must exist as long as the function is called. Throws
  /// ConfigurationError under the same conditions as other members.
  FunctionProxy(RequiredInterface& interface, MemberDescription description)
      : kind_(description.signature.kind),
        index_(interface.AddCaller(*this, std::move(description))),
        binding_(interface.binding()) {}

  [[nodiscard]] CommandKind kind() const { return kind_; }

  /// Calls the function; must be called in a thread that the interface allows. Replaces the content
  /// of `out`.
  Status operator()(std::span<const std::byte> in, std::vector<std::byte>& out) {
    BytesSink sink(out);
    return Replacing(out, (*this)(in, sink));
  }
  /// Like the operator above, but with a ReplySink. Writes nothing to `out` if the call was not
  /// made.
  Status operator()(std::span<const std::byte> in, ReplySink& out) {
    return CallMember(binding_, index_,
                      [&](CommandBase& command) { return command.ExecuteEncoded(in, out); });
  }

  /// Begins a call; see CommandBase::BeginEncoded(). Sets `command` to the command that executes
  /// the call. `command` is valid until the interface is disconnected.
  Status Begin(std::span<const std::byte> in, std::vector<std::byte>& out, Wakeup<>& ended,
               CommandBase*& command, std::size_t& call) {
    return Replacing(out, CallMember(binding_, index_, [&](CommandBase& bound) {
                       command = &bound;
                       return bound.BeginEncoded(in, out, ended, call);
                     }));
  }

  /// Returns null, because commands are called with encoded values.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*command*/) const override {
    return nullptr;
  }

 private:
  /// Clears `out` after a failed call. `out` is not cleared before the call, because a vector that
  /// grows again is slowly filled with zeros. A successful call has replaced `out` anyway.
  static Status Replacing(std::vector<std::byte>& out, Status status) {
    if (!status) out.clear();
    return status;
  }

  CommandKind kind_;
  std::size_t index_;
  BindingGate& binding_;
};

/// Returns true if calls of this kind are queued in a mailbox while the caller continues.
[[nodiscard]] constexpr bool IsQueued(CommandKind kind) {
  return kind == CommandKind::kVoid || kind == CommandKind::kWrite;
}

/// Returns true if the caller can or must wait until the call was executed.
[[nodiscard]] constexpr bool CanBeAwaited(CommandKind kind) {
  return IsQueued(kind) || WaitsForServer(kind);
}

}  // namespace tendon
