#pragma once

#include <tendon/interface/execution/caller.h>

#include <chrono>
#include <cstddef>

namespace tendon {

/// The caller's end of a command, a member of the component that calls it. Filled when its required
/// interface is connected; until then a call returns kNotConnected, kDisabled while the server has
/// switched the command off, and kNotActive while it does not run; a read is answered by one that
/// rests, though not by one that is faulted.
///
/// A call of a void or write function never waits, locks or allocates; a read runs the server's
/// code, or asks another process and waits for at most the interface's deadline, unless it is
/// mirrored. To wait until the server has executed the call is spelt out:
///
///     move_to_.Wait(goal, 50ms)
///
/// kTimeout: it was not executed and will not be; kOutcomeUnknown: it was started, how it ends
/// cannot be known; kNotConnected: disconnected meanwhile; kWouldDeadlock: the server runs in this
/// very thread. Functions that return something can only be called so.
///
/// Thread safety: those of one required interface are called by one thread at a time: where its
/// component is a task, by its thread. Those of a component without a thread, and where
/// SetCallers() says so, are called by any threads.
template <CommandKind kKind, typename In, typename Out>
class Function final : public Caller {
  static_assert(RequirePayload<In>() && RequirePayload<Out>());
  using Time = std::chrono::nanoseconds;
  static constexpr bool kIsVoid = kKind == CommandKind::kVoid;
  static constexpr bool kIsWrite = kKind == CommandKind::kWrite;
  static constexpr bool kIsRead = kKind == CommandKind::kRead;
  static constexpr bool kIsQualifiedRead = kKind == CommandKind::kQualifiedRead;
  static constexpr bool kIsVoidReturn = kKind == CommandKind::kVoidReturn;
  static constexpr bool kIsWriteReturn = kKind == CommandKind::kWriteReturn;

 public:
  Status operator()() requires kIsVoid { return Call({}, nothing_); }
  Status operator()(const In& in) requires kIsWrite { return Call(in, nothing_); }
  Status operator()(Out& out) requires kIsRead { return Call({}, out); }
  Status operator()(const In& in, Out& out) requires kIsQualifiedRead { return Call(in, out); }

  Status Wait(Time timeout) requires kIsVoid { return CallAndWait({}, nothing_, timeout); }
  Status Wait(const In& in, Time timeout) requires kIsWrite {
    return CallAndWait(in, nothing_, timeout);
  }
  Status Wait(Out& out, Time timeout) requires kIsVoidReturn {
    return CallAndWait({}, out, timeout);
  }
  Status Wait(const In& in, Out& out, Time timeout) requires kIsWriteReturn {
    return CallAndWait(in, out, timeout);
  }

  /// How old the value is that was read last, where it is a copy: see RequiredInterface::Mirror().
  /// 0 where each read asks; the largest value where nothing was read yet, or nobody can be asked.
  [[nodiscard]] Time age() requires kIsRead {
    Time age = Time::max();
    if (binding_ == nullptr) return age;
    (void)CallMember(*binding_, index_, [&age](const CommandBase& command) -> Status {
      age = command.age();
      return Status::kDone;
    });
    return age;
  }

  /// Whether a call would reach a server now.
  [[nodiscard]] bool is_connected() {
    return binding_ != nullptr && binding_->Enter([this](const BoundMember* members) {
      return members != nullptr && members[index_].is_reached();
    });
  }

  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    return AdaptByLayout<In, Out>(command);
  }

 private:
  friend class RequiredInterface;

  static Command<In, Out>& Typed(CommandBase& command) {
    return static_cast<Command<In, Out>&>(command);
  }

  Status Call(const In& in, Out& out) {
    if (binding_ == nullptr) return Status::kNotConnected;
    return CallMember(*binding_, index_,
                      [&](CommandBase& command) { return Typed(command).Execute(in, out); });
  }
  Status CallAndWait(const In& in, Out& out, Time timeout) {
    if (binding_ == nullptr) return Status::kNotConnected;
    return CallMember(*binding_, index_,
                      [&](CommandBase& command) { return Typed(command).Wait(in, out, timeout); });
  }

  BindingGate* binding_ = nullptr;
  std::size_t index_ = 0;
  [[no_unique_address]] None nothing_;
};

using VoidFunction = Function<CommandKind::kVoid, None, None>;
template <typename T>
using WriteFunction = Function<CommandKind::kWrite, T, None>;
template <typename T>
using ReadFunction = Function<CommandKind::kRead, None, T>;
template <typename In, typename Out>
using QualifiedReadFunction = Function<CommandKind::kQualifiedRead, In, Out>;
template <typename T>
using VoidReturnFunction = Function<CommandKind::kVoidReturn, None, T>;
template <typename In, typename Out>
using WriteReturnFunction = Function<CommandKind::kWriteReturn, In, Out>;

}  // namespace tendon
