#pragma once

#include <gcm_gui/plot/series/curve_set.h>

#include <QFrame>
#include <QPoint>
#include <QStaticText>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

class QLabel;
class QGridLayout;

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
  /// True if another signal is offered in place of the value.
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

/// The curves of a plot with their present values. Each curve has one row; the rows are placed from
/// left to right, then downwards.
class Legend : public QFrame {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent);

  /// Sets the rows. The cost is low if only values have changed.
  void setEntries(const std::vector<LegendEntry>& entries);
  /// Sets the available width in pixels. As many rows as fit are placed side by side.
  void setRoom(int width);
  [[nodiscard]] const std::vector<LegendRow*>& rows() const { return rows_; }

 Q_SIGNALS:
  void toggled(const QString& path);
  void removeRequested(const QString& path);
  void remapRequested(const QString& path);
  void lookRequested(const QString& path);
  void dragRequested(const QString& path);

 private:
  void makeRows(std::size_t count);
  void alignColumns();
  void arrange();
  [[nodiscard]] int widest(const std::function<int(const LegendRow&)>& width) const;

  QGridLayout* grid_;
  int room_ = 0;    // available width in pixels
  int across_ = 0;  // number of rows side by side
  std::size_t arranged_ = 0;
  std::vector<LegendRow*> rows_;
  int value_width_ = 0;  // never shrinks, so that the legend does not jitter
};

/// Formats `value` with two digits more than the labels of an axis that shows `range`.
[[nodiscard]] QString LegendValue(double value, const AxisRange& range);

}  // namespace tendon::gui
