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

/// The hands on a plot's canvas, while data streams:
///
/// - wheel: zoom in time around the mouse; Ctrl+wheel: in values; sideways: move in time
/// - drag: zoom to the rectangle, Escape gives up; Shift+drag: move
/// - double click, End: live again
/// - Alt+Left, Alt+Right, the mouse's buttons for it: back to what was shown before, and forward
/// - keys: Left, Right, + and -, Ctrl with + and - for values
/// - A and B: cursors under the mouse, to be dragged; Delete removes them
/// - S: sweep, and scroll again
/// - M: marks, or none
/// - L: logarithmic values, and linear ones again
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
  /// What is marked where the mouse rests.
  bool help(const QHelpEvent& event);
  bool key(const QKeyEvent& event);
  bool plainKey(int key);
  void showGrip(int x);
  void endDrag();

  PlotView& view_;
  Drag drag_ = Drag::kNone;
  QPoint pressed_;
  QPoint last_;
  Cursor cursor_ = Cursor::kA;  // that is dragged
  bool moves_values_ = false;
};

}  // namespace tendon::gui
