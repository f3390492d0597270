#pragma once

#include <QFont>
#include <QStyledItemDelegate>

namespace tendon::gui {

/// Draws a row of the window's lists: a letter or a shape, the name, a dim detail, and at the right
/// its value with shape and unit. Asks the model by RowRole; colours and fonts are the theme's.
class RowDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// The first column also shows this one at its right edge; -1, the default, for none.
  void setValueColumn(int column) { value_column_ = column; }
  /// In every column numbers stand right and words left; unless told, all but the first are right.
  void setAllLeft(bool all_left) { all_left_ = all_left; }

  /// Left of the first column, in pixels.
  void setLeftInset(int pixels) { left_inset_ = pixels; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override;

 private:
  /// What the name keeps of a row that also shows its value, in pixels.
  [[nodiscard]] int roomForName(const QRect& rect, const QModelIndex& index) const;
  // Both return what is left of `rect`; of a value at least `name` pixels.
  QRect paintValue(QPainter& painter, QRect rect, const QModelIndex& index, int name) const;
  QRect paintName(QPainter& painter, QRect rect, const QModelIndex& index) const;
  /// At a fixed place, so that trends stand below each other; nothing where that is not `free`.
  void paintTrend(QPainter& painter, const QRect& row, const QRect& free,
                  const QModelIndex& index) const;

  int value_column_ = -1;
  bool all_left_ = false;
  int left_inset_ = 10;
};

}  // namespace tendon::gui
