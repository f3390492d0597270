#include <gcm_gui/window/audit_line.h>

#include <gcm_gui/models/text.h>

namespace tendon::gui {
namespace {

const QString kAct = QStringLiteral(": call a command ");
const QString kAllowed = QStringLiteral(": allowed");
const QString kRefused = QStringLiteral(": refused");

}  // namespace

// Parses a record such as "desk (operator, 10.0.0.7:40112): call a command arm/Control.MoveTo:
// allowed". Starts from the end, because the name of a program may contain any text.
std::optional<SentCommand> SentCommandOf(const message::LogRecord& record) {
  if (record.source != "audit") return std::nullopt;
  const QString text = ToQString(record.text);
  const qsizetype act = text.lastIndexOf(kAct);
  const bool is_refused = text.endsWith(kRefused);
  if (act < 0 || (!is_refused && !text.endsWith(kAllowed))) return std::nullopt;
  const qsizetype begin = act + kAct.size();
  const qsizetype end = text.size() - (is_refused ? kRefused : kAllowed).size();
  if (end <= begin) return std::nullopt;
  return SentCommand{.path = ToQString(record.process) + '/' + text.mid(begin, end - begin),
                     .who = text.left(act),
                     .is_refused = is_refused};
}

}  // namespace tendon::gui
