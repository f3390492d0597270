#pragma once

#include <tendon/interface/caller.h>

#include <cstddef>

namespace tendon {

/// The caller's end of a command, a member of the component that calls it. Filled when its required
/// interface is connected; until then a call returns kNotConnected.
///
/// Thread safety: all functions of one required interface are called by one thread at a time,
/// usually the component's own. A call of a void or write function never waits, locks or
/// allocates; a read runs the server's code, or asks another process and waits for at most the
/// interface's deadline.
template <CommandKind kKind, Payload In, Payload Out>
class Function final : public Caller {
  static constexpr bool kIsVoid = kKind == CommandKind::kVoid;
  static constexpr bool kIsWrite = kKind == CommandKind::kWrite;
  static constexpr bool kIsRead = kKind == CommandKind::kRead;
  static constexpr bool kIsQualifiedRead = kKind == CommandKind::kQualifiedRead;

 public:
  Status operator()() requires kIsVoid { return Call(nothing_, nothing_); }
  Status operator()(const In& in) requires kIsWrite { return Call(in, nothing_); }
  Status operator()(Out& out) requires kIsRead { return Call(nothing_, out); }
  Status operator()(const In& in, Out& out) requires kIsQualifiedRead { return Call(in, out); }

  /// Whether a call would reach a server now.
  [[nodiscard]] bool is_connected() {
    if (binding_ == nullptr) return false;
    const BindingPointer::Call call(*binding_);
    return call.get() != nullptr && call.get()->commands[index_] != nullptr;
  }

  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    return AdaptByLayout<In, Out>(command);
  }

 private:
  friend class RequiredInterface;

  Status Call(const In& in, Out& out) {
    if (binding_ == nullptr) return Status::kNotConnected;
    const BindingPointer::Call call(*binding_);
    if (call.get() == nullptr) return Status::kNotConnected;
    CommandBase* command = call.get()->commands[index_];
    if (command == nullptr) return Status::kNotConnected;
    return static_cast<Command<In, Out>*>(command)->Execute(in, out);
  }

  BindingPointer* binding_ = nullptr;
  std::size_t index_ = 0;
  [[no_unique_address]] None nothing_;
};

using VoidFunction = Function<CommandKind::kVoid, None, None>;
template <Payload T>
using WriteFunction = Function<CommandKind::kWrite, T, None>;
template <Payload T>
using ReadFunction = Function<CommandKind::kRead, None, T>;
template <Payload In, Payload Out>
using QualifiedReadFunction = Function<CommandKind::kQualifiedRead, In, Out>;

}  // namespace tendon
