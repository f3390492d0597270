#pragma once

#include <tendon/process/log/log_messages.h>

#include <QString>
#include <optional>

namespace tendon::gui {

/// A command that a program has sent to a component. The process of the component has logged it.
struct SentCommand {
  QString path;  ///< "robot/arm/Control.MoveTo"
  QString who;   ///< name, role and address of that program
  bool is_refused = false;

  bool operator==(const SentCommand&) const = default;
};

/// Parses a log record; empty if it does not report a sent command.
[[nodiscard]] std::optional<SentCommand> SentCommandOf(const message::LogRecord& record);

}  // namespace tendon::gui
