#pragma once

#include <gcm_gui/models/catalogue_filter.h>
#include <gcm_gui/models/selection.h>

#include <QModelIndex>
#include <QTimer>
#include <QWidget>
#include <cstdint>

class QLabel;
class QLineEdit;
class QToolButton;

namespace tendon::gui {

class CatalogueTree;

/// The left column: the catalogue with a filter field. Processes that have been lost or ended for
/// half a minute are hidden. A button shows them, and a filter still finds them.
class CataloguePanel : public QWidget {
  Q_OBJECT

 public:
  CataloguePanel(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                 QWidget* parent = nullptr);

  [[nodiscard]] CatalogueTree& tree() const { return *tree_; }
  [[nodiscard]] QLineEdit& filterField() const { return *field_; }

 public Q_SLOTS:
  void focusFilter();
  /// Sets the present time, in ns since 1970.
  void setNow(qint64 now);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showCount();
  void foldGone();
  void showSelected();
  void showFoldedCount(int folded);
  [[nodiscard]] bool isFolded(const QModelIndex& process) const;

  CatalogueFilter& filter_;
  const Selection& selection_;
  QLabel* count_;
  QLineEdit* field_;
  CatalogueTree* tree_;
  QToolButton* gone_;
  std::int64_t now_ = 0;
  QTimer count_soon_;
};

}  // namespace tendon::gui
