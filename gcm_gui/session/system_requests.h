#pragma once

#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/base/result.h>
#include <tendon/gcm/diagnosis.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <functional>
#include <string>

namespace tendon::gui {

/// The changes that a user can make to the system. Each function returns at once. The activity list
/// shows the result of the request, and the catalogue shows the new state.
class SystemActions {
 public:
  SystemActions() = default;
  SystemActions(const SystemActions&) = delete;
  SystemActions& operator=(const SystemActions&) = delete;
  virtual ~SystemActions() = default;

  /// Connects two interfaces. The GCM refuses this if `required` is already connected.
  virtual void connectInterfaces(const InterfaceName& required, const InterfaceName& provided) = 0;
  /// Connects two interfaces. If `required` is already connected, the connection is replaced in one
  /// step; if the new connection is refused, the old one is restored.
  virtual void connectOrReplace(const InterfaceName& required, const InterfaceName& provided) = 0;
  virtual void disconnectInterface(const InterfaceName& required) = 0;
  /// Undoes the newest step that is not undone, even if another user made it. A step of another
  /// user, or a step on the lifecycle of a component, is undone only at the second call.
  virtual void undo() = 0;
  /// Removes a lost process from the catalogue.
  virtual void forget(const std::string& process) = 0;
  /// Starts, suspends, stops or restarts a component.
  virtual void executeLifecycleOrder(LifecycleVerb verb, const std::string& process,
                                     const std::string& component) = 0;
  /// From now on, the process drops log records below `level`.
  virtual void setLogLevel(const std::string& process, LogLevel level) = 0;
};

/// Calls commands for the user. Each function returns at once. A handler is called in the GUI
/// thread, at most once, and never after the end of the session.
class CommandCalls {
 public:
  using SchemaHandler = std::function<void(const Result<Schema>&)>;
  /// Receives the result as JSON, which is empty if the command has no result, and the duration in
  /// s.
  using ResultHandler = std::function<void(const Result<std::string>&, double)>;

  CommandCalls() = default;
  CommandCalls(const CommandCalls&) = delete;
  CommandCalls& operator=(const CommandCalls&) = delete;
  virtual ~CommandCalls() = default;

  /// Requests the schema of a type from `process`.
  virtual void findSchema(const std::string& process, Fingerprint type, SchemaHandler handler) = 0;
  /// Calls a command by its path, such as "robot/arm/Control.MoveTo"; `argument` is JSON, or empty
  /// for none. The call appears in the activity list.
  virtual void callCommand(const std::string& path, const std::string& argument,
                           ResultHandler handler) = 0;
  /// Reads a value as JSON with a read command. The call is not in the activity list, because the
  /// user did not request it.
  using ValueHandler = std::function<void(const Result<std::string>&)>;
  virtual void readValue(const std::string& path, ValueHandler handler) = 0;
};

/// Checks an existing or requested connection. Each function returns at once. A handler is called
/// in the GUI thread, at most once, and never after the end of the session.
class ConnectionChecks {
 public:
  using DiagnosisHandler = std::function<void(const Result<Diagnosis>&)>;

  ConnectionChecks() = default;
  ConnectionChecks(const ConnectionChecks&) = delete;
  ConnectionChecks& operator=(const ConnectionChecks&) = delete;
  virtual ~ConnectionChecks() = default;

  /// Makes the seven checks of `gcm explain`, up to the first failure. One check asks the
  /// provider's process, which may take as long as any other request. Fails like Diagnose().
  virtual void diagnose(const message::ConnectionEnds& ends, DiagnosisHandler handler) = 0;
};

}  // namespace tendon::gui
