#pragma once

#include <gcm_gui/models/filter/catalogue_filter.h>
#include <gcm_gui/models/selection.h>

#include <QTimer>
#include <QWidget>

class QLabel;
class QLineEdit;

namespace tendon::gui {

class CatalogueTree;

/// The left column: the catalogue, and a field that narrows it.
class CataloguePanel : public QWidget {
  Q_OBJECT

 public:
  CataloguePanel(CatalogueFilter& filter, Selection& selection, SignalSource& source,
                 QWidget* parent = nullptr);

  [[nodiscard]] CatalogueTree& tree() const { return *tree_; }
  [[nodiscard]] QLineEdit& filterField() const { return *field_; }

 public Q_SLOTS:
  void focusFilter();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void showCount();

  CatalogueFilter& filter_;
  QLabel* count_;
  QLineEdit* field_;
  CatalogueTree* tree_;
  QTimer count_soon_;
};

}  // namespace tendon::gui
