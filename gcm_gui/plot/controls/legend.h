#pragma once

#include <gcm_gui/plot/controls/legend_row.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QFrame>
#include <QString>
#include <cstddef>
#include <functional>
#include <vector>

class QGridLayout;

namespace tendon::gui {

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
