#include <gcm_gui/guard/guarded_application.h>

#include <gcm_gui/guard/exception_guard.h>

#include <QBackingStore>
#include <QEvent>
#include <QPaintEngine>
#include <QPointer>
#include <QWidget>

namespace tendon::gui {
namespace {

/// Ends the painter of a widget. Qt's widgets are compiled without exceptions: if an exception
/// passes a Qt function, the painter of that function is never ended, and the window cannot paint
/// any more.
void CloseLeftPainter(const QWidget& widget) {
  QBackingStore* store = widget.backingStore();
  QPaintDevice* device = store == nullptr ? nullptr : store->paintDevice();
  QPaintEngine* engine = device == nullptr ? nullptr : device->paintEngine();
  if (engine != nullptr && engine->isActive()) engine->setActive(false);
}

}  // namespace

int GuardedApplication::exec() {
  while (true) {
    try {
      return QApplication::exec();
    } catch (...) {
      ExceptionGuard::instance().recordException(nullptr, ViewWork::kHandling);
    }
  }
}

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  const bool is_paint = event->type() == QEvent::Paint;
  if (is_paint && ExceptionGuard::instance().isCovered(receiver)) return true;
  const QPointer<QObject> there(receiver);
  try {
    return QApplication::notify(receiver, event);
  } catch (...) {
    ExceptionGuard::instance().recordException(there,
                                               is_paint ? ViewWork::kDrawing : ViewWork::kHandling);
    if (is_paint && there != nullptr && there->isWidgetType())
      CloseLeftPainter(static_cast<const QWidget&>(*receiver));
    return true;
  }
}

}  // namespace tendon::gui
