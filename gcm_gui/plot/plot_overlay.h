#pragma once

#include <QRect>
#include <QString>
#include <QWidget>
#include <optional>

namespace tendon::gui {

/// What lies above the curves and changes without them: the rectangle being dragged, the line under
/// the mouse with its time, a hint while the plot is empty, and a note on what it shows. The mouse
/// passes through it.
class PlotOverlay : public QWidget {
  Q_OBJECT

 public:
  /// Always as large as `canvas`, its parent.
  explicit PlotOverlay(QWidget* canvas);

  void setRubberBand(const std::optional<QRect>& rect);
  /// A vertical line at `x` with `text` at its foot.
  void setHairline(std::optional<int> x, const QString& text = {});
  void setHint(const QString& hint);
  /// In the upper left corner.
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
