#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>

#include <functional>
#include <string>

namespace tendon::gui {

/// Calls commands for the user. Each function returns at once; a handler is called in the GUI
/// thread, at most once, and not after the end of the session.
class CommandCalls {
 public:
  using SchemaHandler = std::function<void(const Result<Schema>&)>;
  /// The answer as JSON, empty if the command has no result; and the duration in s.
  using AnswerHandler = std::function<void(const Result<std::string>&, double)>;

  CommandCalls() = default;
  CommandCalls(const CommandCalls&) = delete;
  CommandCalls& operator=(const CommandCalls&) = delete;
  virtual ~CommandCalls() = default;

  /// Requests the schema of a type from `process`.
  virtual void findSchema(const std::string& process, Fingerprint type, SchemaHandler handler) = 0;
  /// Calls "robot/arm/Control.MoveTo"; `argument` is JSON, or empty for none. The call appears in
  /// the activity list.
  virtual void callCommand(const std::string& path, const std::string& argument,
                           AnswerHandler handler) = 0;
  /// Reads a value as JSON by a read command. It is not in the activity list, because the user did
  /// not request it.
  using ValueHandler = std::function<void(const Result<std::string>&)>;
  virtual void readValue(const std::string& path, ValueHandler handler) = 0;
};

}  // namespace tendon::gui
