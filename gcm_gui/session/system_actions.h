#pragma once

#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/process/life/life_messages.h>

#include <string>

namespace tendon::gui {

/// The changes that a user can make to the system. Each function returns at once; the activity list
/// shows the outcome, and the catalogue the new state.
class SystemActions {
 public:
  SystemActions() = default;
  SystemActions(const SystemActions&) = delete;
  SystemActions& operator=(const SystemActions&) = delete;
  virtual ~SystemActions() = default;

  virtual void connectInterfaces(const InterfaceName& required, const InterfaceName& provided) = 0;
  virtual void disconnectInterface(const InterfaceName& required) = 0;
  /// Connects a connected interface to another provider in one step; restores the former connection
  /// if the new one is refused.
  virtual void replaceConnection(const InterfaceName& required, const InterfaceName& provided) = 0;
  /// Undoes the newest step that is not undone, whoever made it. A step of another user, or on a
  /// component's life cycle, is only undone at the second call.
  virtual void undo() = 0;
  /// Removes the remains of a lost process.
  virtual void forget(const std::string& process) = 0;
  /// Starts, suspends, stops or restarts a component.
  virtual void steer(LifeVerb verb, const std::string& process, const std::string& component) = 0;
  /// From now on the process drops records below `level`.
  virtual void setLogLevel(const std::string& process, LogLevel level) = 0;
};

}  // namespace tendon::gui
