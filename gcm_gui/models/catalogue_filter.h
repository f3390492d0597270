#pragma once

#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/filter_expression.h>

#include <QAbstractProxyModel>
#include <QString>
#include <QTimer>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

namespace tendon::gui {

/// Shows the rows of a CatalogueModel that match a filter, together with their parents. Setting a
/// filter visits every row of the model once and resets this model. Without a filter, all rows are
/// shown.
class CatalogueFilter : public QAbstractProxyModel {
  Q_OBJECT

 public:
  explicit CatalogueFilter(CatalogueModel& model, QObject* parent = nullptr);

  [[nodiscard]] CatalogueModel& catalogue() const { return model_; }
  [[nodiscard]] bool active() const { return !expression_.empty(); }
  /// Returns the number of matching rows; without a filter, the number of all rows of the model.
  [[nodiscard]] int matchCount() const;
  [[nodiscard]] QModelIndex indexOf(const QString& path) const;
  [[nodiscard]] const CatalogueItem* item(const QModelIndex& index) const;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
  [[nodiscard]] bool hasChildren(const QModelIndex& parent) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent) const override;
  [[nodiscard]] QModelIndex mapToSource(const QModelIndex& index) const override;
  [[nodiscard]] QModelIndex mapFromSource(const QModelIndex& index) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

 public Q_SLOTS:
  /// Sets the filter after a delay of 120 ms. A call within this time starts the delay again.
  void setText(const QString& text);
  /// Sets the filter at once.
  void applyText(const QString& text);

 Q_SIGNALS:
  void filterApplied();

 private:
  using Rows = std::vector<const CatalogueItem*>;
  /// The shown child rows of each parent. The key null holds the processes.
  using Shown = std::unordered_map<const CatalogueItem*, Rows>;

  void connectModel();
  /// Adds `item` and the rows below it to `shown` as far as the filter shows them, and adds the
  /// number of matches to `meant`. Returns false if no row is shown.
  bool collect(const CatalogueItem& item, Shown& shown, int& meant) const;
  void collectAll();
  void takeIn(const CatalogueItem& item);
  void takeOut(const CatalogueItem& item);
  void drop(const CatalogueItem& item);
  void recheck(const CatalogueItem& item);
  void onDataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles);
  /// Returns the number of rows that have children, among `item` and the rows below it.
  [[nodiscard]] std::size_t parentsIn(const CatalogueItem& item) const;
  [[nodiscard]] bool isShown(const CatalogueItem& item) const;
  [[nodiscard]] const Rows& below(const CatalogueItem* item) const;
  [[nodiscard]] int rowOf(const CatalogueItem& item) const;
  [[nodiscard]] QModelIndex indexFor(const CatalogueItem* item, int column = 0) const;

  CatalogueModel& model_;
  FilterExpression expression_;
  Shown shown_;                 // rows shown by the active filter
  std::optional<int> matches_;  // matches of the active filter; empty after the model has changed
  QString pending_;
  QTimer typing_;
};

}  // namespace tendon::gui
