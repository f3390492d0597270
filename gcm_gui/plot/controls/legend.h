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

/// The content of one row of a legend.
struct LegendEntry {
  QString path;
  QString name;
  QString value;  ///< already formatted
  QString unit;
  int color_index = 0;
  bool stale = false;  ///< waits for its source: grey; `name` contains the source
  bool old = false;    ///< its component does not run: grey; `name` contains the reason
  bool shown = true;   ///< the curve is visible
  QString figures;     ///< statistics of the visible range, at the end; empty if not requested

  bool operator==(const LegendEntry&) const = default;
};

/// One curve: colour, name, value, unit, and a cross to remove it, visible under the mouse and with
/// the focus. A click or Space hides and shows the curve, Delete removes it, Enter opens scale,
/// offset and axis, and dragging moves the signal elsewhere. A curve that waits for its source
/// offers "remap…" (R) in place of its value. A menu has all these functions too.
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
  /// The user wants to show another signal in its place.
  void remapRequested(const QString& path);
  /// The user wants to change its scale, offset or axis.
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

/// The curves of a plot with their present values: one row each, from left to right and downwards.
class Legend : public QFrame {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent);

  /// Cheap if only values change.
  void setEntries(const std::vector<LegendEntry>& entries);
  /// The available width in pixels; as many rows as fit stand side by side.
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
  int room_ = 0;    // pixels across
  int across_ = 0;  // the number of rows side by side
  std::size_t arranged_ = 0;
  std::vector<LegendRow*> rows_;
  int value_width_ = 0;  // only grows, so that the legend does not jitter
};

/// Formats `value` with two digits more than the labels of an axis that shows `range`.
[[nodiscard]] QString LegendValue(double value, const AxisRange& range);

}  // namespace tendon::gui
