#pragma once

#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/execution/converting_command.h>
#include <tendon/interface/execution/gate.h>
#include <tendon/interface/interface_description.h>

#include <cstddef>
#include <memory>

namespace tendon {

/// The target of one function of a required interface.
struct BoundMember {
  CommandBase* command = nullptr;  ///< null for an optional function without a command
  const Flag* enabled = nullptr;
  const ComponentAccess* server = nullptr;  ///< null if faults are not reported (state tables)

  /// True if a call now would reach a server.
  [[nodiscard]] bool is_reached() const noexcept {
    return command != nullptr && !is_server_faulted();
  }
  [[nodiscard]] bool is_server_faulted() const noexcept {
    return server != nullptr && server->is_faulted();
  }
};

/// Points to the array of members of a connected interface, in the order of its functions; null if
/// the interface is not connected. A pointer to the first member saves an indirection per call. All
/// members change at once.
using BindingGate = Gate<const BoundMember>;

/// Runs `call(CommandBase&) -> Status` if the member is bound and enabled. Otherwise returns the
/// reason as a Status.
template <typename Call>
Status CallMember(BindingGate& gate, std::size_t index, Call call) {
  return gate.Enter([&](const BoundMember* members) -> Status {
    if (members == nullptr) return Status::kNotConnected;
    const BoundMember& member = members[index];
    CommandBase* const command = member.command;
    if (command == nullptr) return Status::kNotConnected;
    if (member.is_server_faulted()) return Status::kNotActive;
    if (!member.enabled->Get()) return Status::kDisabled;
    return call(*command);
  });
}

/// The calling end of a member: a function of a required interface, or an event of a provided
/// interface.
class MemberCaller {
 public:
  MemberCaller() = default;
  MemberCaller(const MemberCaller&) = delete;
  MemberCaller& operator=(const MemberCaller&) = delete;
  virtual ~MemberCaller() = default;

  /// Returns null if `command` can be called directly. Otherwise returns a converting command that
  /// must be called instead. `command` has the caller's signature and must outlive the result.
  [[nodiscard]] virtual std::unique_ptr<CommandBase> Adapt(CommandBase& command) const = 0;
};

/// Returns null if the layouts are equal, so that the command can be called directly. Otherwise
/// returns a command that uses the codec.
template <Payload In, Payload Out>
std::unique_ptr<CommandBase> AdaptByLayout(CommandBase& command) {
  if (command.Is<In, Out>()) return nullptr;
  return std::make_unique<ConvertingCommand<In, Out>>(command);
}

}  // namespace tendon
