#include <gcm_gui/views/link_button.h>

#include <gcm_gui/theme/theme.h>

#include <QToolButton>

namespace tendon::gui {

QToolButton* MakeLinkButton(const QString& text, const QString& name) {
  auto* link = new QToolButton;
  link->setText(text);
  link->setObjectName(name);
  link->setAccessibleName(text);
  link->setCursor(Qt::PointingHandCursor);
  SetRole(*link, QStringLiteral("accent"));
  return link;
}

}  // namespace tendon::gui
