#pragma once

#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/process/life/messages.h>

#include <string>

namespace tendon::gui {

/// What a user can change of the system. Each returns at once; what came of it is told by the
/// activity list, and the catalogue shows it.
class SystemActions {
 public:
  SystemActions() = default;
  SystemActions(const SystemActions&) = delete;
  SystemActions& operator=(const SystemActions&) = delete;
  virtual ~SystemActions() = default;

  virtual void connectInterfaces(const InterfaceName& required, const InterfaceName& provided) = 0;
  virtual void disconnectInterface(const InterfaceName& required) = 0;
  /// Connects a connected interface to another provider, as one step; to the former one again when
  /// that is refused.
  virtual void replaceConnection(const InterfaceName& required, const InterfaceName& provided) = 0;
  /// Takes back the newest step that stands, whoever has made it; what is not this window's, or was
  /// ordered of a component, only when it is asked for a second time.
  virtual void undo() = 0;
  /// Removes what is left of a lost process.
  virtual void forget(const std::string& process) = 0;
  /// Starts, suspends, stops or restarts a component.
  virtual void steer(LifeVerb verb, const std::string& process, const std::string& component) = 0;
  /// What is below `level` the process drops from now on.
  virtual void setLogLevel(const std::string& process, LogLevel level) = 0;
};

}  // namespace tendon::gui
