#pragma once

#include <QTreeView>
#include <functional>

namespace tendon::gui {

class RowDelegate;

/// A tree or a list in the style of the window: rows of 24 pixels, no frame, and a tint over the
/// whole row if it is selected or under the pointer.
class RowView : public QTreeView {
  Q_OBJECT

 public:
  explicit RowView(QWidget* parent = nullptr);

  [[nodiscard]] RowDelegate& rows() const { return *delegate_; }
  /// Sets the text that is shown in the middle while there are no rows.
  void setEmptyText(const QString& text) { empty_text_ = text; }

 protected:
  void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
  void drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const override;
  void paintEvent(QPaintEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  void drawInside(const std::function<void()>& draw) const;
  void drawGuardedRow(QPainter* painter, const QStyleOptionViewItem& option,
                      const QModelIndex& index) const;

  RowDelegate* delegate_;
  QString empty_text_;
};

/// Makes a list without arrows. Its first column is as wide as the list. `title` is for screen
/// readers.
[[nodiscard]] RowView* MakeRowList(QAbstractItemModel& model, const QString& name,
                                   const QString& title, const QString& empty_text);

/// Fills `page` with `bar` and, below it, `list`. The list has one selected row at a time, and
/// words are left-aligned in all of its columns.
void FillPage(QWidget& page, QWidget* bar, RowView* list);

}  // namespace tendon::gui
