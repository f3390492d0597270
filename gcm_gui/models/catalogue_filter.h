#pragma once

#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/filter_expression.h>

#include <QAbstractProxyModel>
#include <QString>
#include <QTimer>
#include <optional>
#include <unordered_map>
#include <vector>

namespace tendon::gui {

/// Shows the rows of a CatalogueModel that match a filter, and their parents. A new filter visits
/// every row of the model once and resets this model; without a filter it passes all rows through.
class CatalogueFilter : public QAbstractProxyModel {
  Q_OBJECT

 public:
  explicit CatalogueFilter(CatalogueModel& model, QObject* parent = nullptr);

  [[nodiscard]] CatalogueModel& catalogue() const { return model_; }
  [[nodiscard]] bool active() const { return !expression_.empty(); }
  /// The number of matching rows; without a filter all rows of the model.
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
  /// Takes effect after 120 ms without another call.
  void setText(const QString& text);
  /// Takes effect at once.
  void applyText(const QString& text);

 Q_SIGNALS:
  void filterApplied();

 private:
  using Rows = std::vector<const CatalogueItem*>;
  /// The shown child rows by parent; the null key holds the processes.
  using Shown = std::unordered_map<const CatalogueItem*, Rows>;

  void connectModel();
  /// Adds the shown rows at and below `item` to `shown`, and adds the number of matches to `meant`.
  /// Returns false if there are none.
  bool collect(const CatalogueItem& item, Shown& shown, int& meant) const;
  void collectAll();
  void takeIn(const CatalogueItem& item);
  void takeOut(const CatalogueItem& item);
  void drop(const CatalogueItem& item);
  void recheck(const CatalogueItem& item);
  void onDataChanged(const QModelIndex& first, const QModelIndex& last, const QList<int>& roles);
  /// The number of rows with children at and below `item`.
  [[nodiscard]] std::size_t parentsIn(const CatalogueItem& item) const;
  [[nodiscard]] bool isShown(const CatalogueItem& item) const;
  [[nodiscard]] const Rows& below(const CatalogueItem* item) const;
  [[nodiscard]] int rowOf(const CatalogueItem& item) const;
  [[nodiscard]] QModelIndex indexFor(const CatalogueItem* item, int column = 0) const;

  CatalogueModel& model_;
  FilterExpression expression_;
  Shown shown_;                 // of an active filter
  std::optional<int> matches_;  // of an active filter; unset after the model has changed
  QString pending_;
  QTimer typing_;
};

}  // namespace tendon::gui
