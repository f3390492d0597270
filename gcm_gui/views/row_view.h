#pragma once

#include <QTreeView>
#include <functional>

namespace tendon::gui {

class RowDelegate;

/// A tree or a list in the window's look: rows of 24 pixels, no frame, the whole row tinted when it
/// is selected or pointed at.
class RowView : public QTreeView {
  Q_OBJECT

 public:
  explicit RowView(QWidget* parent = nullptr);

  [[nodiscard]] RowDelegate& rows() const { return *delegate_; }
  /// What to say in the middle while there are no rows.
  void setEmptyText(const QString& text) { empty_text_ = text; }

 protected:
  void drawRow(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
  void drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const override;
  void paintEvent(QPaintEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  void drawInside(const std::function<void()>& draw) const;
  void drawFencedRow(QPainter* painter, const QStyleOptionViewItem& option,
                     const QModelIndex& index) const;

  RowDelegate* delegate_;
  QString empty_text_;
};

/// A list: no arrows, the first column as wide as there is room. `title` is for a screen reader.
[[nodiscard]] RowView* MakeRowList(QAbstractItemModel& model, const QString& name,
                                   const QString& title, const QString& empty_text);

}  // namespace tendon::gui
