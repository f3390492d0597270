#pragma once

#include <tendon/interface/required_interface.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

/// A function that is created at run time from its description and is called with encoded values:
/// on behalf of another process, a console or a script.
class FunctionProxy final : public MemberCaller {
 public:
  /// Adds itself to `interface`, which must live as long as this object is called. Throws
  /// ConfigurationError like any other member.
  FunctionProxy(RequiredInterface& interface, MemberDescription description)
      : kind_(description.signature.kind),
        index_(interface.AddCaller(*this, std::move(description))),
        binding_(interface.binding()) {}

  [[nodiscard]] CommandKind kind() const { return kind_; }

  /// Calls the function, in a thread that the interface allows. Replaces the content of `out`.
  Status operator()(std::span<const std::byte> in, std::vector<std::byte>& out) {
    BytesSink sink(out);
    return Replacing(out, (*this)(in, sink));
  }
  /// The same; writes nothing to `out` if there was no call.
  Status operator()(std::span<const std::byte> in, AnswerSink& out) {
    return CallMember(binding_, index_,
                      [&](CommandBase& command) { return command.ExecuteEncoded(in, out); });
  }

  /// See CommandBase::BeginEncoded(). `command`, valid until the interface is disconnected,
  /// executes the call.
  Status Begin(std::span<const std::byte> in, std::vector<std::byte>& out, Wakeup<>& ended,
               CommandBase*& command, std::size_t& call) {
    return Replacing(out, CallMember(binding_, index_, [&](CommandBase& bound) {
                       command = &bound;
                       return bound.BeginEncoded(in, out, ended, call);
                     }));
  }

  /// Commands are called with encoded values.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*command*/) const override {
    return nullptr;
  }

 private:
  /// A successful call has replaced `out`. Clearing it before the call would be slow, because a
  /// vector that grows again writes zeroes.
  static Status Replacing(std::vector<std::byte>& out, Status status) {
    if (!status) out.clear();
    return status;
  }

  CommandKind kind_;
  std::size_t index_;
  BindingGate& binding_;
};

/// True if a call waits in a mailbox while its caller continues.
[[nodiscard]] constexpr bool IsQueued(CommandKind kind) {
  return kind == CommandKind::kVoid || kind == CommandKind::kWrite;
}

/// True if a caller can, or must, wait until the call was executed.
[[nodiscard]] constexpr bool CanBeAwaited(CommandKind kind) {
  return IsQueued(kind) || WaitsForServer(kind);
}

}  // namespace tendon
