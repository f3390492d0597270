#pragma once

#include <QFont>
#include <QStyledItemDelegate>

namespace tendon::gui {

/// Draws a row of the window's lists: a letter or shape, the name, a dim detail, and on the right
/// the value with shape and unit. Reads the model by RowRole, and colours and fonts from the theme.
class RowDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// The column shown at the right edge of the first column; -1, the default, for none.
  void setValueColumn(int column) { value_column_ = column; }
  /// By default all columns but the first are right-aligned; true left-aligns words in all.
  void setAllLeft(bool all_left) { all_left_ = all_left; }

  /// The margin left of the first column, in pixels.
  void setLeftInset(int pixels) { left_inset_ = pixels; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override;

 private:
  /// The width in pixels that remains for the name in a row that also shows its value.
  [[nodiscard]] int roomForName(const QRect& rect, const QModelIndex& index) const;
  // Both return the remaining part of `rect`; paintValue() leaves at least `name` pixels.
  QRect paintValue(QPainter& painter, QRect rect, const QModelIndex& index, int name) const;
  QRect paintName(QPainter& painter, QRect rect, const QModelIndex& index) const;
  /// Paints at a fixed place, so that trends are aligned; nothing if that is not within `free`.
  void paintTrend(QPainter& painter, const QRect& row, const QRect& free,
                  const QModelIndex& index) const;

  int value_column_ = -1;
  bool all_left_ = false;
  int left_inset_ = 10;
};

}  // namespace tendon::gui
