#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>

class QAction;

namespace tendon::gui {

class RowView;

/// Which columns of the catalogue are seen. Name and value alone are one line without a header, in
/// which a name has what it needs; with any other column each has its own place under a header.
/// GUI thread.
class CatalogueColumns : public QObject {
  Q_OBJECT

 public:
  /// `tree` shows a CatalogueFilter, and outlives this.
  explicit CatalogueColumns(RowView& tree);

  /// One for each column but the name, which is always seen: for menus.
  [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
  void setShown(int column, bool shown);
  [[nodiscard]] bool isShown(int column) const;

  /// Which, and how wide, for the next time.
  [[nodiscard]] QByteArray state() const;
  /// What is no state changes nothing.
  void restore(const QByteArray& state);
  /// As at the first start.
  void reset();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Look {
    int width = 0;  // pixels, also while it is hidden
    bool is_shown = false;
  };

  void setLook(int column, const Look& look);
  void arrange();
  void noteWidth(int column, int width);
  void fitName();
  [[nodiscard]] bool isTable() const;

  RowView& tree_;
  // From the second column on.
  QList<QAction*> actions_;
  QList<int> widths_;
  bool fitting_ = false;
};

}  // namespace tendon::gui
