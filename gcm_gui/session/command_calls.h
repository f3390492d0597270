#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>

#include <functional>
#include <string>

namespace tendon::gui {

/// Commands that a user calls from the window. Each function returns at once; a handler is called
/// in the GUI thread, at most once, and not after the session has ended.
class CommandCalls {
 public:
  using SchemaHandler = std::function<void(const Result<Schema>&)>;
  /// JSON, empty where the command answers nothing; and the seconds it took.
  using AnswerHandler = std::function<void(const Result<std::string>&, double)>;

  CommandCalls() = default;
  CommandCalls(const CommandCalls&) = delete;
  CommandCalls& operator=(const CommandCalls&) = delete;
  virtual ~CommandCalls() = default;

  /// What a type looks like, as `process` knows it.
  virtual void findSchema(const std::string& process, Fingerprint type, SchemaHandler handler) = 0;
  /// Calls "robot/arm/Control.MoveTo"; `argument` is JSON, empty for none. The activity list has
  /// it, too.
  virtual void callCommand(const std::string& path, const std::string& argument,
                           AnswerHandler handler) = 0;
  /// What a read command says now, as JSON. Nobody has asked for it: no list has it.
  using ValueHandler = std::function<void(const Result<std::string>&)>;
  virtual void readValue(const std::string& path, ValueHandler handler) = 0;
};

}  // namespace tendon::gui
