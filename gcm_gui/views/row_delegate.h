#pragma once

#include <QFont>
#include <QStyledItemDelegate>

namespace tendon::gui {

/// Draws a row of the window's lists: on the left a letter or a shape, the name, and a dim detail;
/// on the right the value with its shape and unit. Reads the model by RowRole; colours and fonts
/// come from the theme.
class RowDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// Sets the column that is shown at the right edge of the first column; -1, the default, for
  /// none.
  void setValueColumn(int column) { value_column_ = column; }
  /// By default, all columns except the first one are right-aligned. If true, words are
  /// left-aligned in all columns.
  void setAllLeft(bool all_left) { all_left_ = all_left; }

  /// The margin left of the first column, in pixels.
  void setLeftInset(int pixels) { left_inset_ = pixels; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override;

 private:
  /// In a row that also shows its value, returns the width in pixels that is reserved for the name.
  [[nodiscard]] int roomForName(const QRect& rect, const QModelIndex& index) const;
  // paintValue() and paintName() return the part of `rect` that is still free. paintValue()
  // reserves at least `name` pixels for the name.
  QRect paintValue(QPainter& painter, QRect rect, const QModelIndex& index, int name) const;
  QRect paintName(QPainter& painter, QRect rect, const QModelIndex& index) const;
  /// Paints the trend at a fixed position, so that all trends are aligned. Paints nothing if this
  /// position is not within `free`.
  void paintTrend(QPainter& painter, const QRect& row, const QRect& free,
                  const QModelIndex& index) const;

  int value_column_ = -1;
  bool all_left_ = false;
  int left_inset_ = 10;
};

}  // namespace tendon::gui
