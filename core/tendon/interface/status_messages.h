#pragma once

#include <tendon/base/log.h>
#include <tendon/interface/execution/scratch.h>
#include <tendon/interface/provided_interface.h>

#include <string>
#include <string_view>

namespace tendon {

/// Sends messages of a component to people, as the events `Status`, `Warning` and `Error` of one of
/// its provided interfaces. Each event has a text. Every message is also logged. Make it a member
/// of the component.
///
/// Thread safety: the same as for the component's events. Sending a message costs as much as Log().
/// In a cycle, it allocates only until each mailbox slot has held the longest text once.
class StatusMessages {
 public:
  /// Adds the events to `interface`; `source` is the name under which they are logged.
  StatusMessages(ProvidedInterface& interface, std::string source);
  StatusMessages(const StatusMessages&) = delete;
  StatusMessages& operator=(const StatusMessages&) = delete;

  void SendStatus(std::string_view text) { Send(LogLevel::kInfo, status_, text); }
  void SendWarning(std::string_view text) { Send(LogLevel::kWarning, warning_, text); }
  void SendError(std::string_view text) { Send(LogLevel::kError, error_, text); }

 private:
  void Send(LogLevel level, WriteEvent<std::string>& event, std::string_view text);

  std::string source_;
  Scratch<std::string> text_;
  WriteEvent<std::string> status_;
  WriteEvent<std::string> warning_;
  WriteEvent<std::string> error_;
};

}  // namespace tendon
