#pragma once

#include <QPoint>
#include <QRect>
#include <QStaticText>
#include <QString>
#include <QWidget>
#include <optional>

namespace tendon::gui {

/// The contents of one row of a legend.
struct LegendEntry {
  QString path;
  QString recording = {};  ///< name of its file; empty if the curve is not recorded
  QString name;            ///< of a recorded curve, with its shift
  QString value;           ///< already formatted
  QString unit;
  int color_index = 0;
  bool stale = false;  ///< the curve waits for its source: grey; `name` contains the source
  bool old = false;    ///< the curve's component does not run: grey; `name` contains the reason
  bool shown = true;   ///< the curve is visible
  QString figures;     ///< statistics of the visible part, shown last; empty if not requested

  bool operator==(const LegendEntry&) const = default;
};

/// The row of one curve: colour, name, value, unit, and a cross that removes the curve. The cross
/// is visible while the row is under the mouse or has the focus. A click or Space hides and shows
/// the curve, Delete removes it, Enter opens scale, offset and axis, and dragging the row moves the
/// signal to another plot. A recorded curve has a dashed colour and the name of its file. If the
/// curve waits for its source, the row shows "remap…" (R) instead of the value. All these functions
/// are also in a menu.
class LegendRow : public QWidget {
  Q_OBJECT

 public:
  explicit LegendRow(QWidget* parent);

  void setEntry(const LegendEntry& entry);
  [[nodiscard]] const LegendEntry& entry() const { return entry_; }
  [[nodiscard]] int nameWidth() const;
  [[nodiscard]] int valueWidth() const;
  [[nodiscard]] int unitWidth() const;
  /// Sets the column widths, which are the same in all rows of a legend.
  void setColumns(int name_width, int value_width, int unit_width);

 Q_SIGNALS:
  void toggled(const QString& path);
  void removeRequested(const QString& path);
  /// Emitted when the user wants to show another signal instead of this one.
  void remapRequested(const QString& path);
  /// Emitted when the user wants to change scale, offset or axis of the curve.
  void lookRequested(const QString& path);
  void dragRequested(const QString& path);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] static bool isOwnKey(int key);
  [[nodiscard]] QRect markRect() const;
  [[nodiscard]] QRect valueRect() const;
  void paintMark(QPainter& painter) const;
  [[nodiscard]] bool isGrey() const { return entry_.stale || entry_.old; }
  /// True if the row offers another signal instead of a value.
  [[nodiscard]] bool isRemappable() const { return entry_.stale && entry_.recording.isEmpty(); }
  [[nodiscard]] bool isPointedAt() const { return underMouse() || hasFocus(); }

  LegendEntry entry_;
  std::optional<QPoint> pressed_;
  QStaticText name_;
  QStaticText value_;
  QStaticText unit_;
  QStaticText figures_;
  int name_width_ = 0;
  int value_width_ = 0;
  int unit_width_ = 0;
};

}  // namespace tendon::gui
