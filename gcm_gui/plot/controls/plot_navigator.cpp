#include <gcm_gui/plot/controls/plot_navigator.h>

#include <gcm_gui/plot/controls/plot_overlay.h>
#include <gcm_gui/plot/plot_view.h>

#include <QContextMenuEvent>
#include <QCursor>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kNotch = 120;        // one step of a wheel, in eighths of a degree
constexpr double kNotchFactor = 0.8;  // the window changes by this factor per step of the wheel
constexpr double kKeyPan = 0.1;       // fraction of the canvas per key press
constexpr double kKeyShift = 0.01;    // likewise, for recordings
constexpr int kSmallestBand = 5;      // pixels; a smaller rectangle counts as a click
constexpr int kPanThreshold = 12;     // pixels up or down before a drag also moves the values

}  // namespace

PlotNavigator::PlotNavigator(PlotView& view) : QObject(&view), view_(view) {
  view.canvas()->installEventFilter(this);
  view.canvas()->setMouseTracking(true);
  view.canvas()->setFocusPolicy(Qt::StrongFocus);
}

bool PlotNavigator::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseMove:
      return move(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonRelease:
      return release(static_cast<const QMouseEvent&>(*event));
    case QEvent::MouseButtonDblClick:
      endDrag();
      view_.gestures().goLive();
      return true;
    case QEvent::Leave:
      view_.setHover({});
      view_.gestures().endRun();
      return false;
    case QEvent::Wheel:
      return wheel(static_cast<const QWheelEvent&>(*event));
    case QEvent::ContextMenu:
      Q_EMIT view_.menuRequested(static_cast<const QContextMenuEvent&>(*event).pos());
      return true;
    case QEvent::ToolTip:
      return help(static_cast<const QHelpEvent&>(*event));
    case QEvent::KeyPress:
      return key(static_cast<const QKeyEvent&>(*event));
    default:
      return QObject::eventFilter(watched, event);
  }
}

bool PlotNavigator::press(const QMouseEvent& event) {
  if (event.button() == Qt::BackButton || event.button() == Qt::ForwardButton) {
    event.button() == Qt::BackButton ? view_.gestures().goBack() : view_.gestures().goForward();
    return true;
  }
  if (event.button() != Qt::LeftButton || view_.curves().empty()) return false;
  pressed_ = last_ = event.pos();
  moves_values_ = false;
  drag_ = event.modifiers().testFlag(Qt::ShiftModifier) ? Drag::kPan : Drag::kZoom;
  if (const auto cursor = view_.cursors().at(event.pos().x())) {
    drag_ = Drag::kCursor;
    cursor_ = *cursor;
  }
  recording_ = event.modifiers().testFlag(Qt::ControlModifier)
                   ? view_.recordedCurves().recordingAt(event.pos())
                   : QString();
  if (drag_ == Drag::kZoom && !recording_.isEmpty()) {
    drag_ = Drag::kShift;
    view_.gestures().endRun();
    view_.canvas()->setCursor(Qt::SizeHorCursor);
  }
  if (drag_ == Drag::kPan) {
    view_.gestures().endRun();
    view_.canvas()->setCursor(Qt::ClosedHandCursor);
  }
  return true;
}

bool PlotNavigator::move(const QMouseEvent& event) {
  const QPoint position = event.pos();
  view_.setHover(position.x());
  if (drag_ == Drag::kZoom) {
    const QRect band = QRect(pressed_, position).normalized() & view_.canvas()->rect();
    view_.overlay().setRubberBand(band);
  } else if (drag_ == Drag::kCursor) {
    view_.cursors().place(cursor_, position.x());
  } else if (drag_ == Drag::kShift) {
    view_.recordedCurves().move(recording_, position.x() - last_.x());
    last_ = position;
  } else if (drag_ == Drag::kNone) {
    showGrip(position.x());
  } else {
    if (std::abs(position.y() - pressed_.y()) > kPanThreshold) moves_values_ = true;
    view_.gestures().panTime(last_.x() - position.x());
    if (moves_values_) view_.gestures().panValues(position.y() - last_.y());
    last_ = position;
  }
  return drag_ != Drag::kNone;
}

bool PlotNavigator::release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || drag_ == Drag::kNone) return false;
  const QRect band = QRect(pressed_, event.pos()).normalized() & view_.canvas()->rect();
  const bool zooms =
      drag_ == Drag::kZoom && band.width() >= kSmallestBand && band.height() >= kSmallestBand;
  endDrag();
  if (zooms) view_.gestures().zoomTo(band);
  return true;
}

void PlotNavigator::endDrag() {
  if (drag_ == Drag::kShift) view_.gestures().endRun();
  drag_ = Drag::kNone;
  view_.overlay().setRubberBand({});
  view_.canvas()->unsetCursor();
}

bool PlotNavigator::wheel(const QWheelEvent& event) {
  if (view_.curves().empty()) return false;
  const QPoint turned = event.angleDelta();
  const QPointF at = event.position();
  const double factor = std::pow(kNotchFactor, turned.y() / kNotch);
  if (std::abs(turned.x()) > std::abs(turned.y())) {
    view_.gestures().panTime(-turned.x());
  } else if (event.modifiers().testFlag(Qt::ControlModifier)) {
    view_.gestures().zoomValues(factor, at.y());
  } else {
    view_.gestures().zoomTime(factor, at.x());
  }
  return true;
}

void PlotNavigator::showGrip(int x) {
  if (view_.cursors().at(x)) {
    view_.canvas()->setCursor(Qt::SplitHCursor);
  } else {
    view_.canvas()->setCursor(Qt::ArrowCursor);
  }
}

bool PlotNavigator::help(const QHelpEvent& event) {
  QToolTip::showText(event.globalPos(), view_.marks().textAt(event.pos().x()), view_.canvas());
  return true;
}

// Returns the position of the mouse; while it is elsewhere, the centre of the canvas.
QPoint PlotNavigator::mouse() const {
  const QPoint mouse = view_.canvas()->mapFromGlobal(QCursor::pos());
  return view_.canvas()->rect().contains(mouse) ? mouse : view_.canvas()->rect().center();
}

bool PlotNavigator::plainKey(int key) {
  const int x = mouse().x();
  switch (key) {
    case Qt::Key_A:
      view_.cursors().place(Cursor::kA, x);
      return true;
    case Qt::Key_B:
      view_.cursors().place(Cursor::kB, x);
      return true;
    case Qt::Key_T:
      return view_.recordedCurves().askForShift(view_.recordedCurves().recordingAt(mouse()));
    case Qt::Key_Delete:
      view_.cursors().show(false);
      return true;
    case Qt::Key_E:
      Q_EMIT view_.marksToggled();
      return true;
    case Qt::Key_S:
      view_.setMotion(view_.timeWindow().motion() == TimeWindow::Motion::kScroll
                          ? TimeWindow::Motion::kSweep
                          : TimeWindow::Motion::kScroll);
      return true;
    case Qt::Key_L:
      view_.setScale(view_.curves().scale() == ValueScale::kLinear ? ValueScale::kLogarithmic
                                                                   : ValueScale::kLinear);
      return true;
    default:
      return false;
  }
}

bool PlotNavigator::shiftKey(const QKeyEvent& event) {
  const bool is_arrow = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
  const Qt::KeyboardModifiers held = event.modifiers() & ~Qt::KeypadModifier;
  if (!is_arrow || held != Qt::ControlModifier) return false;
  const QString recording = view_.recordedCurves().recordingAt(mouse());
  if (recording.isEmpty()) return false;
  const double step = kKeyShift * view_.canvas()->width();
  view_.recordedCurves().move(recording, event.key() == Qt::Key_Left ? -step : step);
  return true;
}

bool PlotNavigator::key(const QKeyEvent& event) {
  if (event.modifiers() == Qt::NoModifier && plainKey(event.key())) return true;
  if (shiftKey(event)) return true;
  const double width = view_.canvas()->width();
  const QPoint centre = view_.canvas()->rect().center();
  const bool values = event.modifiers().testFlag(Qt::ControlModifier);
  const auto zoom = [&](double factor) {
    values ? view_.gestures().zoomValues(factor, centre.y())
           : view_.gestures().zoomTime(factor, centre.x());
  };
  switch (event.key()) {
    case Qt::Key_Escape:
      if (drag_ == Drag::kNone) return false;
      endDrag();
      return true;
    case Qt::Key_Left:
      event.modifiers().testFlag(Qt::AltModifier) ? view_.gestures().goBack()
                                                  : view_.gestures().panTime(-kKeyPan * width);
      return true;
    case Qt::Key_Right:
      event.modifiers().testFlag(Qt::AltModifier) ? view_.gestures().goForward()
                                                  : view_.gestures().panTime(kKeyPan * width);
      return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      zoom(kNotchFactor);
      return true;
    case Qt::Key_Minus:
      zoom(1 / kNotchFactor);
      return true;
    case Qt::Key_End:
      view_.gestures().goLive();
      return true;
    default:
      return false;
  }
}

}  // namespace tendon::gui
