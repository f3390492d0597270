#pragma once

#include <tendon/process/log/messages.h>

#include <QString>
#include <optional>

namespace tendon::gui {

/// A command that some program has sent to a component, as the component's process has noted it.
struct SentCommand {
  QString path;  ///< "robot/arm/Control.MoveTo"
  QString who;   ///< name, role and address of the program
  bool is_refused = false;

  bool operator==(const SentCommand&) const = default;
};

/// Nothing for a record that tells of something else.
[[nodiscard]] std::optional<SentCommand> SentCommandOf(const message::LogRecord& record);

}  // namespace tendon::gui
