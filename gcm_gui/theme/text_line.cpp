#include <gcm_gui/theme/text_line.h>
#include <gcm_gui/theme/theme.h>

#include <QLabel>

namespace tendon::gui {

QLabel* MakeTextLine(const QString& name, const QString& role) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  SetRole(*label, role);
  return label;
}

}  // namespace tendon::gui
