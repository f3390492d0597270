#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/description.h>
#include <tendon/lockfree/guarded_pointer.h>

#include <memory>
#include <vector>

namespace tendon {

/// The commands that the functions of a required interface call, in the functions' order; null for
/// an optional one without a partner. Replaced as a whole, so that all functions connect at once.
struct Binding {
  std::vector<CommandBase*> commands;
};
using BindingPointer = GuardedPointer<Binding>;

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
