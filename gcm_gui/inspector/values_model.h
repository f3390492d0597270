#pragma once

#include <gcm_gui/session/signal_source.h>
#include <tendon/manager/description.h>

#include <QAbstractTableModel>
#include <QList>
#include <QSet>
#include <QString>
#include <vector>

namespace tendon::gui {

/// Every number in the state tables of one component, with its newest value, its unit and how it
/// went in the last seconds.
class ValuesModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kValue, kColumnCount };

  /// Values a trend has; they come 10 times a second.
  static constexpr qsizetype kTrend = 100;

  using QAbstractTableModel::QAbstractTableModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  /// `path` of the component; null for none. The values come by showValues().
  void show(const QString& path, const ComponentDescription* component, bool stale);
  /// The paths of its columns: what to watch.
  [[nodiscard]] QSet<QString> columns() const;
  /// Of a row; empty for none.
  [[nodiscard]] QString unit(int row) const;

 public Q_SLOTS:
  void showValues(const QString& column, const tendon::gui::ColumnValues& values);

 private:
  struct Block {  // the rows of one column
    QString column;
    QString name;
    ColumnValues values;
    std::vector<QList<double>> trends = {};  // of each channel
    [[nodiscard]] int rows() const;
    bool operator==(const Block& other) const { return column == other.column; }
  };
  struct Place {
    const Block* block;
    std::size_t channel;
  };
  [[nodiscard]] Place placeOf(int row) const;
  static void addToTrends(Block& block);
  void replaceRows(Block& block, int first, const ColumnValues& values);

  std::vector<Block> blocks_;
  bool stale_ = false;
};

}  // namespace tendon::gui
