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

/// What one row of a legend says.
struct LegendEntry {
  QString path;
  QString name;
  QString value;  ///< already in digits
  QString unit;
  int color_index = 0;
  bool stale = false;  ///< then `name` says also what is waited for, in grey
  bool old = false;    ///< its component stands still: all of it is grey, `name` says why
  bool shown = true;   ///< the curve is visible
  QString figures;     ///< of the visible range, behind all; empty when they are not asked for

  bool operator==(const LegendEntry&) const = default;
};

/// One curve: colour, name, value, unit, and a cross to remove it, which appears under the mouse
/// and with the focus. A click or Space hides and shows the curve, Delete removes it, and dragging
/// it takes the signal elsewhere. One that is
/// waited for offers "remap…" in place of its value; the key is R. Enter asks for its scale, offset
/// and axis; all of it is also in a menu.
class LegendRow : public QWidget {
  Q_OBJECT

 public:
  explicit LegendRow(QWidget* parent);

  void setEntry(const LegendEntry& entry);
  [[nodiscard]] const LegendEntry& entry() const { return entry_; }
  [[nodiscard]] int nameWidth() const;
  [[nodiscard]] int valueWidth() const;
  [[nodiscard]] int unitWidth() const;
  /// All rows of a legend have the same columns.
  void setColumns(int name_width, int value_width, int unit_width);

 Q_SIGNALS:
  void toggled(const QString& path);
  void removeRequested(const QString& path);
  /// Another signal is to be shown in its place.
  void remapRequested(const QString& path);
  /// Its scale, offset or axis is to be another.
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

/// The curves of a plot with their present values: a row each, from left to right and down.
class Legend : public QFrame {
  Q_OBJECT

 public:
  explicit Legend(QWidget* parent);

  /// Cheap when only values change.
  void setEntries(const std::vector<LegendEntry>& entries);
  /// So many pixels across are there: the rows stand side by side as far as they fit.
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
  int across_ = 0;  // rows side by side
  std::size_t arranged_ = 0;
  std::vector<LegendRow*> rows_;
  int value_width_ = 0;  // only grows, so that the legend does not tremble
};

/// `value` with two digits more than the labels of an axis that shows `range`.
[[nodiscard]] QString LegendValue(double value, const AxisRange& range);

}  // namespace tendon::gui
