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

  /// By whom the interface allows. `out` is replaced.
  Status operator()(std::span<const std::byte> in, std::vector<std::byte>& out) {
    BytesSink sink(out);
    return Replacing(out, (*this)(in, sink));
  }
  /// Likewise; `out` gets nothing where there was no call.
  Status operator()(std::span<const std::byte> in, AnswerSink& out) {
    return CallMember(binding_, index_,
                      [&](CommandBase& command) { return command.ExecuteEncoded(in, out); });
  }

  /// As BeginEncoded(); `command` is whose call it is, until the interface is disconnected.
  Status Begin(std::span<const std::byte> in, std::vector<std::byte>& out, Wakeup<>& ended,
               CommandBase*& command, std::size_t& call) {
    return Replacing(out, CallMember(binding_, index_, [&](CommandBase& bound) {
                       command = &bound;
                       return bound.BeginEncoded(in, out, ended, call);
                     }));
  }

  /// Commands are called by their encoded face.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*command*/) const override {
    return nullptr;
  }

 private:
  /// A call that was made has replaced it. It is not emptied before, for what grows is filled with
  /// zeroes first, and that may be much.
  static Status Replacing(std::vector<std::byte>& out, Status status) {
    if (!status) out.clear();
    return status;
  }

  CommandKind kind_;
  std::size_t index_;
  BindingGate& binding_;
};

/// Whether a call of it waits in a mailbox, and its caller need not.
[[nodiscard]] constexpr bool IsQueued(CommandKind kind) {
  return kind == CommandKind::kVoid || kind == CommandKind::kWrite;
}

/// Whether its caller may wait until it was executed, or must.
[[nodiscard]] constexpr bool CanBeAwaited(CommandKind kind) {
  return IsQueued(kind) || WaitsForServer(kind);
}

}  // namespace tendon
