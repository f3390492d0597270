#pragma once

#include <gcm_gui/models/catalogue_item.h>
#include <gcm_gui/models/facts/column_arrivals.h>
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
#include <vector>

namespace tendon::gui {

/// The catalogue as a tree: process, component, interface, member, and below the columns of state
/// tables their values; in further columns how often values come, how old they are, and what is
/// connected to what. What comes later than the first of it is marked for ten seconds. What stays
/// the same in an update stays where it is, also over a restart of its process. GUI thread.
class CatalogueModel : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kRate, kAge, kConnected, kColumnCount };

  explicit CatalogueModel(QObject* parent = nullptr, const Clock& clock = SteadyClock());
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

  /// Invalid where there is none.
  [[nodiscard]] QModelIndex indexOf(const QString& path) const;
  /// Null for an invalid index. Valid until the next update.
  [[nodiscard]] const CatalogueItem* item(const QModelIndex& index) const;
  /// Rows in all, without those below columns.
  [[nodiscard]] int itemCount() const;

  /// The numbers at and below a path, in order; empty where nothing is known of it yet.
  [[nodiscard]] QList<CurveKey> signalsBelow(const QString& path) const;
  /// Why values at and below the path of a component, or of one of its signals, are old.
  [[nodiscard]] Standstill standstill(const QString& path) const;
  /// The column that a row at or below it belongs to, or empty.
  [[nodiscard]] QString columnOf(const QModelIndex& index) const;

 public Q_SLOTS:
  void update(const tendon::Catalog& catalogue, const tendon::gui::Touched& touched);
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);
  /// These are listened to from now on, so that their silence means something.
  void setWatched(const QSet<QString>& columns) { arrivals_.setWatched(columns); }
  /// The time, ns since 1970, for "lost 12 s".
  void setNow(qint64 now);
  /// Nothing is known any more of what there is: all but values is shown as it was.
  void setOutdated(bool outdated);

 private:
  void updateProcess(const Catalog& catalogue, const ConnectionIndex& connections,
                     const std::string& name);
  void updateComponent(const Catalog& catalogue, const ConnectionIndex& connections,
                       const TouchedPart& part);
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
  /// What there is of a column or a number; nothing before a row has come.
  [[nodiscard]] std::optional<Quantity> quantityOf(const CatalogueItem& item) const;
  [[nodiscard]] QString unitText(const CatalogueItem& item) const;
  /// All of a value that is shown rounded, or may be too long for its column; else empty.
  [[nodiscard]] QString wholeText(const CatalogueItem& item) const;
  [[nodiscard]] QVariant nameData(const CatalogueItem& item, int role) const;
  [[nodiscard]] QVariant valueData(const CatalogueItem& item, int role) const;
  /// Of the columns behind the value; a dash stands for what is not known.
  [[nodiscard]] QVariant factData(const CatalogueItem& item, int column, int role) const;
  [[nodiscard]] QString factText(const CatalogueItem& item, int column) const;
  [[nodiscard]] QString spokenText(const CatalogueItem& item, int column) const;
  [[nodiscard]] std::optional<double> rateOf(const CatalogueItem& item) const;       // Hz
  [[nodiscard]] std::optional<std::int64_t> ageOf(const CatalogueItem& item) const;  // ns
  /// Why the values of its component are old.
  [[nodiscard]] static Standstill standstillOf(const CatalogueItem& item);
  /// Of a value: since its row was written.
  [[nodiscard]] std::optional<std::chrono::nanoseconds> rowAgeOf(const CatalogueItem& item) const;
  /// "suspended · 12 s old" of a value that is old, else empty.
  [[nodiscard]] QString oldTextOf(const CatalogueItem& item) const;

  std::unique_ptr<CatalogueItem> root_;
  QHash<QString, CatalogueItem*> by_path_;
  QHash<QString, ColumnValues> values_;  // of columns
  const Clock& clock_;
  ColumnArrivals arrivals_;
  QHash<QString, std::int64_t> fresh_;  // of rows that are new, by path: until when
  std::int64_t now_ = 0;
  std::int64_t begun_ = 0;  // when the first rows came
  bool outdated_ = false;
};

}  // namespace tendon::gui
