#pragma once

#include <tendon/interface/execution/member_caller.h>

#include <chrono>
#include <cstddef>
#include <memory>

namespace tendon {

/// The caller's end of a command, as a member of the calling component. The six kinds of functions
/// have their own names, from VoidFunction to WriteReturnFunction, at the end of this file. A
/// function is bound when its required interface is connected.
///
/// A call returns kNotConnected before the function is bound, kDisabled while the server has
/// disabled the command, and kNotActive while the server does not run. Reads also work while the
/// server is stopped, but not while it is faulted.
///
/// A call of a void or write function never waits or locks. Within one process, it never allocates;
/// to another process, it allocates only until its buffers have grown to the size of the arguments.
/// A read runs the server's code in the calling thread. If the server is in another process and the
/// function is not mirrored, the read waits for the reply, at most for the interface's read
/// deadline. Wait() waits until the server has executed the call:
///
///     move_to_.Wait(goal, 50ms)
///
/// Wait() returns kTimeout if the call was not executed and never will be, kOutcomeUnknown if its
/// execution has started but the result is unknown, kNotConnected if the connection has ended, and
/// kWouldDeadlock if the server runs in the calling thread. Functions that return a value can only
/// be called with Wait().
///
/// Thread safety: one thread at a time calls the functions of a required interface; in a task, it
/// is the task's own thread. Any thread may call them if the component has no thread, or if
/// SetCallers() allows it.
template <CommandKind kKind, typename In, typename Out>
class Function final : public MemberCaller {
  static_assert(RequirePayload<In>() && RequirePayload<Out>());
  static constexpr bool kIsVoid = kKind == CommandKind::kVoid;
  static constexpr bool kIsWrite = kKind == CommandKind::kWrite;
  static constexpr bool kIsRead = kKind == CommandKind::kRead;
  static constexpr bool kIsQualifiedRead = kKind == CommandKind::kQualifiedRead;
  static constexpr bool kIsVoidReturn = kKind == CommandKind::kVoidReturn;
  static constexpr bool kIsWriteReturn = kKind == CommandKind::kWriteReturn;

 public:
  /// Calls the command.
  Status operator()() requires kIsVoid { return Call({}, nothing_); }
  Status operator()(const In& in) requires kIsWrite { return Call(in, nothing_); }
  Status operator()(Out& out) requires kIsRead { return Call({}, out); }
  Status operator()(const In& in, Out& out) requires kIsQualifiedRead { return Call(in, out); }

  /// Calls the command and waits at most `timeout` until the server has executed it.
  Status Wait(std::chrono::nanoseconds timeout) requires kIsVoid {
    return CallAndWait({}, nothing_, timeout);
  }
  Status Wait(const In& in, std::chrono::nanoseconds timeout) requires kIsWrite {
    return CallAndWait(in, nothing_, timeout);
  }
  Status Wait(Out& out, std::chrono::nanoseconds timeout) requires kIsVoidReturn {
    return CallAndWait({}, out, timeout);
  }
  Status Wait(const In& in, Out& out, std::chrono::nanoseconds timeout) requires kIsWriteReturn {
    return CallAndWait(in, out, timeout);
  }

  /// Returns the age of the value that a mirrored function read last; see
  /// RequiredInterface::Mirror(). Returns 0 if each read goes to the server, and the largest value
  /// if no value was read or there is no server.
  [[nodiscard]] std::chrono::nanoseconds age() requires kIsRead {
    std::chrono::nanoseconds age = std::chrono::nanoseconds::max();
    if (binding_ == nullptr) return age;
    (void)CallMember(*binding_, index_, [&age](const CommandBase& command) -> Status {
      age = command.age();
      return Status::kDone;
    });
    return age;
  }

  /// True if a call would reach a server now.
  [[nodiscard]] bool is_connected() {
    return binding_ != nullptr && binding_->Enter([this](const BoundMember* members) {
      return members != nullptr && members[index_].is_reached();
    });
  }

 private:
  friend class RequiredInterface;

  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& command) const override {
    if constexpr (Payload<In> && Payload<Out>) return AdaptByLayout<In, Out>(command);
    return nullptr;
  }

  static auto& Typed(CommandBase& command) { return static_cast<Command<In, Out>&>(command); }

  Status Call(const In& in, Out& out) {
    if (binding_ == nullptr) return Status::kNotConnected;
    return CallMember(*binding_, index_,
                      [&](CommandBase& command) { return Typed(command).Execute(in, out); });
  }
  Status CallAndWait(const In& in, Out& out, std::chrono::nanoseconds timeout) {
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
