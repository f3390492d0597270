#pragma once

#include <tendon/process/log/log_messages.h>

#include <QString>
#include <optional>

namespace tendon::gui {

/// A command from some program to a component, as logged by the component's process.
struct SentCommand {
  QString path;  ///< "robot/arm/Control.MoveTo"
  QString who;   ///< name, role and address of the program
  bool is_refused = false;

  bool operator==(const SentCommand&) const = default;
};

/// Empty for any other record.
[[nodiscard]] std::optional<SentCommand> SentCommandOf(const message::LogRecord& record);

}  // namespace tendon::gui
