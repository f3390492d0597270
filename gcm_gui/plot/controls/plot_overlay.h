#pragma once

#include <QRect>
#include <QString>
#include <QWidget>
#include <optional>

namespace tendon::gui {

/// A layer above the curves that is redrawn without redrawing the curves. It shows the rectangle
/// being dragged, the line at the mouse with its time, a hint while the plot is empty, and a note
/// about the view. Mouse events pass through it.
class PlotOverlay : public QWidget {
  Q_OBJECT

 public:
  /// Creates a child of `canvas`, which always has the same size as the canvas.
  explicit PlotOverlay(QWidget* canvas);

  void setRubberBand(const std::optional<QRect>& rect);
  /// Shows a vertical line at `x`, with `text` at its lower end.
  void setHairline(std::optional<int> x, const QString& text = {});
  void setHint(const QString& hint);
  /// Shows a note in the upper left corner.
  void setNote(const QString& note);
  [[nodiscard]] const QString& note() const { return note_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void changed();
  void paintHairline(QPainter& painter) const;
  void paintNote(QPainter& painter) const;

  std::optional<QRect> band_;
  std::optional<int> line_;
  QString line_text_;
  QString hint_;
  QString note_;
};

}  // namespace tendon::gui
