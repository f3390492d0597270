#include <gcm_gui/window/read_only_mode.h>

#include <QApplication>
#include <QEvent>
#include <QWidget>
#include <utility>

namespace tendon::gui {

ReadOnlyMode::ReadOnlyMode(QString reason, QObject* parent)
    : QObject(parent), reason_(std::move(reason)) {
  qApp->installEventFilter(this);
}

bool ReadOnlyMode::eventFilter(QObject* watched, QEvent* event) {
  const bool may_be_enabled =
      event->type() == QEvent::Show || event->type() == QEvent::EnabledChange;
  if (may_be_enabled && watched->isWidgetType() && watched->property("changesSystem").toBool()) {
    auto& widget = static_cast<QWidget&>(*watched);
    widget.setToolTip(reason_);
    widget.setEnabled(false);
  }
  return false;
}

}  // namespace tendon::gui
