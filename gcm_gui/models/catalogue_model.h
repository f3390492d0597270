#pragma once

#include <gcm_gui/models/catalogue_item.h>
#include <gcm_gui/models/column_arrivals.h>
#include <gcm_gui/models/shown_clock.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/signal_source.h>

#include <QAbstractItemModel>
#include <QHash>
#include <QList>
#include <QSet>
#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// The catalogue as a tree of processes, components, interfaces and members. Below the columns of
/// state tables are their values. Further columns of the view show rate, age and connections. New
/// rows are marked for ten seconds, except the rows of the first snapshot. An update keeps
/// unchanged rows, even if the process was restarted. GUI thread.
class CatalogueModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kRate, kAge, kConnected, kColumnCount };

  explicit CatalogueModel(QObject* parent = nullptr, const Clock& clock = ShownClock());
  ~CatalogueModel() override;

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
  [[nodiscard]] QStringList mimeTypes() const override;
  [[nodiscard]] QMimeData* mimeData(const QModelIndexList& indexes) const override;

  /// Returns an invalid index if no row has this path.
  [[nodiscard]] QModelIndex indexOf(const QString& path) const;
  /// Returns the item at an index; null if the index is invalid. The pointer is valid until the
  /// next update.
  [[nodiscard]] const CatalogueItem* item(const QModelIndex& index) const;
  /// Returns the number of all rows, without those below columns.
  [[nodiscard]] int itemCount() const;

  /// Returns the numbers at and below a path, in order. Empty while the structure of the values is
  /// unknown.
  [[nodiscard]] QList<CurveKey> signalsBelow(const QString& path) const;
  /// Returns why the values at and below this path (of a component or a signal) are old.
  [[nodiscard]] StaleReason standstill(const QString& path) const;
  /// Returns the path of the column that contains a row; empty if there is none.
  [[nodiscard]] QString columnOf(const QModelIndex& index) const;

 public Q_SLOTS:
  void update(const tendon::Catalogue& catalogue, const tendon::gui::ChangedParts& touched);
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);
  /// Sets the columns that have a subscription. For other columns, missing rows do not count as an
  /// interruption.
  void setWatched(const QSet<QString>& columns) { arrivals_.setWatched(columns); }
  /// Sets the present time in ns since 1970, for texts such as "lost 12 s".
  void setNow(qint64 now);
  /// Pass true while the link to the GCM is lost: everything except the values is then shown in its
  /// last known state.
  void setOutdated(bool outdated);

 private:
  void updateProcess(const Catalogue& catalogue, const ConnectionIndex& connections,
                     const std::string& name);
  void updateComponent(const Catalogue& catalogue, const ConnectionIndex& connections,
                       const ChangedPart& part);
  void merge(CatalogueItem& item, CatalogueItem& fresh);
  void mergeChildren(CatalogueItem& parent, std::vector<std::unique_ptr<CatalogueItem>> fresh);
  void insertChild(CatalogueItem& parent, int row, std::unique_ptr<CatalogueItem> child);
  void removeChild(CatalogueItem& parent, int row);
  void setGone(CatalogueItem& item, bool gone);
  void enter(CatalogueItem& item);
  void forget(CatalogueItem& item);
  void emitValuesChanged(CatalogueItem& item);
  void markFresh(const CatalogueItem& item);
  void dropFresh();

  [[nodiscard]] QModelIndex indexFor(const CatalogueItem& item, int column = kName) const;
  [[nodiscard]] const CatalogueItem& itemFor(const QModelIndex& index) const;
  [[nodiscard]] const CatalogueItem* columnFor(const CatalogueItem& item) const;
  [[nodiscard]] QString valueText(const CatalogueItem& item) const;
  /// Returns the present value of a column or number; empty until a row has arrived.
  [[nodiscard]] std::optional<Quantity> quantityOf(const CatalogueItem& item) const;
  [[nodiscard]] QString unitText(const CatalogueItem& item) const;
  /// Returns the full value if the shown value is rounded or may be too long; otherwise an empty
  /// text.
  [[nodiscard]] QString wholeText(const CatalogueItem& item) const;
  [[nodiscard]] QVariant nameData(const CatalogueItem& item, int role) const;
  [[nodiscard]] QVariant valueData(const CatalogueItem& item, int role) const;
  /// Returns the data of the columns after the value. A dash stands for an unknown fact.
  [[nodiscard]] QVariant factData(const CatalogueItem& item, int column, int role) const;
  [[nodiscard]] QString factText(const CatalogueItem& item, int column) const;
  [[nodiscard]] QString spokenText(const CatalogueItem& item, int column) const;
  [[nodiscard]] std::optional<double> rateOf(const CatalogueItem& item) const;       // Hz
  [[nodiscard]] std::optional<std::int64_t> ageOf(const CatalogueItem& item) const;  // ns
  /// Returns why the values of the item's component are old.
  [[nodiscard]] static StaleReason standstillOf(const CatalogueItem& item);
  /// Returns the time since the row with this value was written.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> rowAgeOf(const CatalogueItem& item) const;
  /// Returns a text such as "suspended · 12 s old" for an old value; otherwise an empty text.
  [[nodiscard]] QString oldTextOf(const CatalogueItem& item) const;

  std::unique_ptr<CatalogueItem> root_;
  QHash<QString, CatalogueItem*> by_path_;
  QHash<QString, ColumnValues> values_;  // by column path
  const Clock& clock_;
  ColumnArrivals arrivals_;
  QHash<QString, std::int64_t> fresh_;  // new rows by path, with the time at which their mark ends
  std::int64_t now_ = 0;
  std::int64_t begun_ = 0;  // the time when the first rows arrived
  bool outdated_ = false;
};

}  // namespace tendon::gui
