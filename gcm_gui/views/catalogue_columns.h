#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>

class QAction;

namespace tendon::gui {

class RowView;

/// Chooses the visible columns of the catalogue. If only name and value are visible, they share one
/// line without a header, and the name gets the width that it needs. If more columns are visible,
/// each column has its own place under a header. GUI thread.
class CatalogueColumns : public QObject {
  Q_OBJECT

 public:
  /// `tree` must show a CatalogueFilter, and must outlive this object.
  explicit CatalogueColumns(RowView& tree);

  /// Returns one action for each column, for menus. The name has no action, because it is always
  /// visible.
  [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
  void setShown(int column, bool shown);
  [[nodiscard]] bool isShown(int column) const;

  /// Returns the visible columns and their widths, for restore().
  [[nodiscard]] QByteArray state() const;
  /// Shows the columns of a saved state. An invalid state is ignored.
  void restore(const QByteArray& state);
  /// Shows the default columns and widths.
  void reset();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Look {
    int width = 0;  // in pixels; kept while the column is hidden
    bool is_shown = false;
  };

  void setLook(int column, const Look& look);
  void arrange();
  void noteWidth(int column, int width);
  void fitName();
  [[nodiscard]] bool isTable() const;

  RowView& tree_;
  // The lists have no entry for the first column.
  QList<QAction*> actions_;
  QList<int> widths_;
  bool fitting_ = false;
};

}  // namespace tendon::gui
