#pragma once

#include <tendon/interface/description.h>
#include <tendon/interface/execution/converting_command.h>
#include <tendon/interface/execution/gate.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace tendon {

/// The commands that the functions of a required interface call, in the functions' order. Replaced
/// as a whole, so that all functions connect at once.
struct Binding {
  struct Member {
    CommandBase* command = nullptr;  ///< null for an optional one without a partner
    const Flag* enabled = nullptr;
  };
  std::vector<Member> members;
};
using BindingGate = Gate<Binding>;

/// `call(CommandBase&) -> Status` where the member is bound and enabled, else why not.
template <typename Call>
Status CallMember(BindingGate& gate, std::size_t index, Call call) {
  return gate.Enter([&](const Binding* binding) -> Status {
    if (binding == nullptr) return Status::kNotConnected;
    const Binding::Member& member = binding->members[index];
    if (member.command == nullptr) return Status::kNotConnected;
    if (!member.enabled->Get()) return Status::kDisabled;
    return call(*member.command);
  });
}

/// The calling end of a member: a function of a required interface, or an event of a provided one.
class Caller {
 public:
  Caller() = default;
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  virtual ~Caller() = default;

  /// Null when `command` can be called as it is, else a command to be called in its place, which
  /// converts. `command` has the caller's signature and outlives the answer.
  [[nodiscard]] virtual std::unique_ptr<CommandBase> Adapt(CommandBase& command) const = 0;
};

/// Adapts by layout: equal ones are called directly, others through the codec.
template <Payload In, Payload Out>
std::unique_ptr<CommandBase> AdaptByLayout(CommandBase& command) {
  if (command.Is<In, Out>()) return nullptr;
  return std::make_unique<ConvertingCommand<In, Out>>(command);
}

}  // namespace tendon
