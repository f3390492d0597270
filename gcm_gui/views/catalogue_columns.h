#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>

class QAction;

namespace tendon::gui {

class RowView;

/// Chooses the visible columns of the catalogue. If only name and value are visible, they share one
/// line without a header, and the name gets the room that it needs; with further columns, each has
/// its own place under a header. GUI thread.
class CatalogueColumns : public QObject {
  Q_OBJECT

 public:
  /// `tree` must show a CatalogueFilter and outlive this object.
  explicit CatalogueColumns(RowView& tree);

  /// For menus: one action per column except the name, which is always visible.
  [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
  void setShown(int column, bool shown);
  [[nodiscard]] bool isShown(int column) const;

  /// The visible columns and their widths, to be restored later.
  [[nodiscard]] QByteArray state() const;
  /// Ignores an invalid state.
  void restore(const QByteArray& state);
  /// Restores the defaults.
  void reset();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Look {
    int width = 0;  // in pixels, kept while hidden
    bool is_shown = false;
  };

  void setLook(int column, const Look& look);
  void arrange();
  void noteWidth(int column, int width);
  void fitName();
  [[nodiscard]] bool isTable() const;

  RowView& tree_;
  // Without the first column.
  QList<QAction*> actions_;
  QList<int> widths_;
  bool fitting_ = false;
};

}  // namespace tendon::gui
