#pragma once

#include <gcm_gui/plot/series/cursors.h>

#include <QObject>
#include <QPoint>

class QHelpEvent;
class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace tendon::gui {

class PlotView;

/// Handles mouse and keys on a plot's canvas, while data streams:
///
/// - wheel: zoom in time around the mouse; Ctrl+wheel: zoom in values; sideways: move in time
/// - drag: zoom to the rectangle, Escape cancels; Shift+drag: move
/// - double click, End: live again
/// - Alt+Left, Alt+Right, or the mouse's buttons for back and forward: history of views
/// - Left, Right, + and - keys: time; Ctrl with + and -: values
/// - A and B: cursors at the mouse, which can be dragged; Delete removes them
/// - S: toggle sweep and scroll
/// - M: toggle marks
/// - L: toggle logarithmic and linear values
class PlotNavigator : public QObject {
  Q_OBJECT

 public:
  /// Watches the canvas of `view`, which owns it.
  explicit PlotNavigator(PlotView& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { kNone, kZoom, kPan, kCursor };

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  /// Shows the marks at the mouse position.
  bool help(const QHelpEvent& event);
  bool key(const QKeyEvent& event);
  bool plainKey(int key);
  void showGrip(int x);
  void endDrag();

  PlotView& view_;
  Drag drag_ = Drag::kNone;
  QPoint pressed_;
  QPoint last_;
  Cursor cursor_ = Cursor::kA;  // the one being dragged
  bool moves_values_ = false;
};

}  // namespace tendon::gui
