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

/// Handles the mouse and the keys on the canvas of a plot, even while new data arrives:
///
/// - wheel: zoom in time around the mouse; Ctrl+wheel: zoom in values; horizontal wheel: move in
/// time
/// - drag: zoom to the rectangle, Escape cancels; Shift+drag: move
/// - Ctrl+drag, Ctrl+Left, Ctrl+Right: move the nearest recording in time
/// - T: edit the shift of the nearest recording
/// - double click, End: live again
/// - Alt+Left, Alt+Right, or the "back" and "forward" buttons of the mouse: history of views
/// - Left, Right, + and -: move and zoom in time; Ctrl with + and -: zoom in values
/// - A and B: place the cursors at the mouse; they can be dragged, and Delete removes them
/// - S: switch between sweep and scroll
/// - M: show or hide the marks
/// - L: switch between logarithmic and linear values
class PlotNavigator : public QObject {
  Q_OBJECT

 public:
  /// Watches the canvas of `view`. The view owns this object.
  explicit PlotNavigator(PlotView& view);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { kNone, kZoom, kPan, kCursor, kShift };

  bool press(const QMouseEvent& event);
  bool move(const QMouseEvent& event);
  bool release(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  /// Shows the marks at the mouse position.
  bool help(const QHelpEvent& event);
  bool key(const QKeyEvent& event);
  bool shiftKey(const QKeyEvent& event);
  [[nodiscard]] QPoint mouse() const;
  bool plainKey(int key);
  void showGrip(int x);
  void endDrag();

  PlotView& view_;
  Drag drag_ = Drag::kNone;
  QPoint pressed_;
  QPoint last_;
  Cursor cursor_ = Cursor::kA;  // the cursor that is being dragged
  QString recording_;           // the recording that is being dragged
  bool moves_values_ = false;
};

}  // namespace tendon::gui
