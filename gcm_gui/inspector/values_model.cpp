#include <gcm_gui/inspector/values_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/table_columns.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {

int ValuesModel::Block::rows() const {
  if (values.channels == nullptr) return 0;  // not known yet
  return values.channels->empty() ? 1 : static_cast<int>(values.channels->size());
}

int ValuesModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  int rows = 0;
  for (const Block& block : blocks_) rows += block.rows();
  return rows;
}

int ValuesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

ValuesModel::Place ValuesModel::placeOf(int row) const {
  for (const Block& block : blocks_) {
    if (row < block.rows()) return {&block, static_cast<std::size_t>(row)};
    row -= block.rows();
  }
  return {};
}

QString ValuesModel::unit(int row) const {
  const auto [block, channel] = placeOf(row);
  if (block == nullptr || !block->values.channels || block->values.channels->empty()) return {};
  return ToQString((*block->values.channels)[channel].unit);
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto [block, channel] = placeOf(index.row());
  const bool known = block->values.channels && !block->values.channels->empty();
  const QString field = known ? ToQString((*block->values.channels)[channel].path) : QString();
  Quantity value{known ? QStringLiteral("…") : block->values.text, unit(index.row())};
  if (known && channel < block->values.values.size()) {
    value = QuantityOf((*block->values.channels)[channel], block->values.values[channel]);
  }
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == kName ? block->name + field : value.number;
    case kPathRole:
    case Qt::ToolTipRole:
      return block->column + field;
    case kFaceRole:
      return static_cast<int>(Face::kMono);
    case kUnitRole:
      return value.unit;
    case kTrendRole:
      if (channel >= block->trends.size()) return {};
      return QVariant::fromValue(block->trends[channel]);
    case kStaleRole:
      return stale_;
    case Qt::AccessibleTextRole:
      return QStringLiteral("%1%2 %3 %4").arg(block->name, field, value.number, value.unit);
    default:
      return {};
  }
}

void ValuesModel::show(const QString& path, const ComponentDescription* component, bool stale) {
  std::vector<Block> fresh;
  if (component != nullptr) {
    for (const auto& table : component->tables) {
      const QString interface = path + '/' + ToQString(table.name);
      const QString prefix = table.name == "state" ? QString() : ToQString(table.name) + '.';
      for (const auto* column : ColumnsOf(table)) {
        const QString name = ToQString(column->name);
        fresh.push_back({interface + '.' + name, prefix + name, {}});
      }
    }
  }
  if (fresh != blocks_) {
    beginResetModel();
    blocks_ = std::move(fresh);
    stale_ = stale;
    endResetModel();
  } else if (stale != stale_) {
    stale_ = stale;
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
  }
}

QSet<QString> ValuesModel::columns() const {
  QSet<QString> columns;
  for (const Block& block : blocks_) columns.insert(block.column);
  return columns;
}

void ValuesModel::addToTrends(Block& block) {
  block.trends.resize(block.values.values.size());
  for (std::size_t channel = 0; channel < block.trends.size(); ++channel) {
    QList<double>& trend = block.trends[channel];
    trend.append(block.values.values[channel]);
    if (trend.size() > kTrend) trend.removeFirst();
  }
}

void ValuesModel::replaceRows(Block& block, int first, const ColumnValues& values) {
  if (block.rows() > 0) {
    beginRemoveRows({}, first, first + block.rows() - 1);
    block.values = {};
    block.trends.clear();
    endRemoveRows();
  }
  Block changed = block;
  changed.values = values;
  changed.trends.clear();
  beginInsertRows({}, first, first + changed.rows() - 1);
  block = std::move(changed);
  endInsertRows();
}

void ValuesModel::showValues(const QString& column, const ColumnValues& values) {
  int first = 0;
  for (Block& block : blocks_) {
    if (block.column != column) {
      first += block.rows();
      continue;
    }
    if (block.values.channels == values.channels) {
      block.values = values;
    } else {
      replaceRows(block, first, values);
    }
    addToTrends(block);
    const int last = first + block.rows() - 1;
    Q_EMIT dataChanged(index(first, 0), index(last, kColumnCount - 1));
    return;
  }
}

}  // namespace tendon::gui
