#pragma once

#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/filter/filter_expression.h>

#include <QSortFilterProxyModel>
#include <QString>
#include <QTimer>

namespace tendon::gui {

/// The rows of a CatalogueModel that a filter means, and those above them.
class CatalogueFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit CatalogueFilter(CatalogueModel& model, QObject* parent = nullptr);

  [[nodiscard]] CatalogueModel& catalogue() const { return model_; }
  [[nodiscard]] bool active() const { return !expression_.empty(); }
  /// Rows that are meant themselves; all of the model's without a filter.
  [[nodiscard]] int matchCount() const;
  [[nodiscard]] QModelIndex indexOf(const QString& path) const;
  [[nodiscard]] const CatalogueItem* item(const QModelIndex& index) const;

 public Q_SLOTS:
  /// Takes effect when nothing more has been typed for 120 ms.
  void setText(const QString& text);
  /// At once.
  void applyText(const QString& text);

 Q_SIGNALS:
  void filterApplied();

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  CatalogueModel& model_;
  FilterExpression expression_;
  QString pending_;
  QTimer typing_;
};

}  // namespace tendon::gui
