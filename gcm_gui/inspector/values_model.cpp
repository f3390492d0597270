#include <gcm_gui/inspector/values_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/sparkline.h>
#include <gcm_gui/models/table_columns.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/controls/rate_badge.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {

int ValuesModel::Block::rows() const {
  if (is_out) return 0;
  const bool has_numbers = isKnown() && !values.fields->empty();
  return has_numbers ? static_cast<int>(values.fields->size()) : 1;
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

ValuesModel::RowPosition ValuesModel::positionOf(int row) const {
  for (const Block& block : blocks_) {
    if (row < block.rows()) return {&block, static_cast<std::size_t>(row)};
    row -= block.rows();
  }
  return {};
}

QString ValuesModel::unit(int row) const {
  const auto [block, field] = positionOf(row);
  if (block == nullptr || !block->values.fields || block->values.fields->empty()) return {};
  return ToQString((*block->values.fields)[field].unit);
}

bool ValuesModel::isNumber(int row) const {
  const Block* block = positionOf(row).block;
  return block != nullptr && block->isKnown() && !block->values.fields->empty();
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const RowPosition position = positionOf(index.row());
  const auto& [block, field] = position;
  const bool has_numbers = block->isKnown() && !block->values.fields->empty();
  const QString field_path =
      has_numbers ? ToQString((*block->values.fields)[field].path) : QString();
  switch (role) {
    case Qt::DisplayRole:
      return index.column() == kName ? block->name + field_path : valueOf(position, role);
    case kPathRole:
      return block->column + field_path;
    case Qt::ToolTipRole:
      if (isSilent(*block)) return silenceOf(*block);
      return QString(block->column + field_path + '\n' + wholeOf(position)).trimmed();
    case kFontStyleRole:
      return static_cast<int>(FontStyle::kMono);
    case kDetailRole:
      return index.column() == kName ? detailOf(*block, field) : QString();
    case kSparklineRole:
      if (field >= block->trends.size()) return {};
      return QVariant::fromValue(
          SparklineOf((*block->values.fields)[field].schema, block->trends[field]));
    case kStaleRole:
      return isOld(*block);
    case kFreshRole:
      return index.column() == kValue ? valueOf(position, role) : QVariant();
    case Qt::AccessibleTextRole:
      return spokenOf(position, field_path);
    default:
      return valueOf(position, role);
  }
}

QString ValuesModel::silenceOf(const Block& block) const {
  if (!block.refusal.isEmpty()) return block.refusal;
  return Words::tr("%1 has not answered for %2 s: click, or press Enter, to ask again")
      .arg(block.column.section('/', 0, 0))
      .arg(kReplyTimeout.count());
}

/// Returns the text for screen readers, including the rate or the age.
QString ValuesModel::spokenOf(const RowPosition& position, const QString& field_path) const {
  const QString detail = detailOf(*position.block, position.field);
  const QString value =
      QStringLiteral("%1%2 %3 %4")
          .arg(position.block->name, field_path, valueOf(position, Qt::DisplayRole).toString(),
               valueOf(position, kUnitRole).toString());
  return detail.isEmpty() ? value : value + QStringLiteral(", ") + detail;
}

QVariant ValuesModel::valueOf(const RowPosition& position, int role) const {
  const auto& [block, field] = position;
  const bool silent = isSilent(*block);
  switch (role) {
    case Qt::DisplayRole:
      if (silent && !block->refusal.isEmpty()) {
        return Words::tr("%1 · ask again").arg(block->refusal);
      }
      if (silent) return Words::tr("no reply in %1 s · ask again").arg(kReplyTimeout.count());
      break;
    case kUnitRole:
      break;
    case kAccentRole:
    case kProseRole:
      return silent;
    case kFreshRole:
      return field < block->changed.size() && clock_.Now() - block->changed[field] < kFresh;
    default:
      return {};
  }
  const bool has_numbers = block->isKnown() && !block->values.fields->empty();
  Quantity value{block->isKnown() && !has_numbers ? block->values.text : QStringLiteral("…"), {}};
  if (has_numbers) {
    const NumericField& shape = (*block->values.fields)[field];
    value.unit = ToQString(shape.unit);
    if (field < block->values.values.size()) {
      value = QuantityOf(shape, block->values.values[field]);
    }
  }
  return role == kUnitRole ? value.unit : value.number;
}

QString ValuesModel::wholeOf(const RowPosition& position) {
  const auto& values = position.block->values;
  if (position.field >= values.values.size()) return {};
  return WholeText((*values.fields)[position.field], values.values[position.field]);
}

bool ValuesModel::isSilent(const Block& block) const {
  const bool can_answer = why_ == StaleReason::kNone || why_ == StaleReason::kUnresponsive;
  if (block.isKnown() || !can_answer || block.awaited == SteadyTime::max()) return false;
  return !block.refusal.isEmpty() || clock_.Now() - block.awaited >= kReplyTimeout;
}

std::optional<std::chrono::nanoseconds> ValuesModel::ageOf(const Block& block) const {
  if (!block.isKnown()) return std::nullopt;
  const SteadyTime written{std::chrono::nanoseconds(block.values.time)};
  const auto age = clock_.Now() - (block.values.time == 0 ? block.arrived : written);
  return std::max(std::chrono::nanoseconds(0), std::chrono::nanoseconds(age));
}

bool ValuesModel::isOld(const Block& block) const {
  return IsStale(why_, ageOf(block), block.rate.hz());
}

QString ValuesModel::detailOf(const Block& block, std::size_t field) const {
  if (field > 0) return {};
  if (isOld(block)) return OldText(why_, ageOf(block));
  return block.rate.hz() > 0 ? RateText(block.rate.hz()) : QString();
}

void ValuesModel::await() {
  for (Block& block : blocks_) {
    if (!block.isKnown() && block.awaited == SteadyTime::max()) block.awaited = clock_.Now();
  }
}

void ValuesModel::awaitNothing() {
  for (Block& block : blocks_) block.awaited = SteadyTime::max();
}

QString ValuesModel::askAgain(int row) {
  const RowPosition position = positionOf(row);
  if (position.block == nullptr || !isSilent(*position.block)) return {};
  for (Block& block : blocks_) {
    if (block.column != position.block->column) continue;
    block.awaited = clock_.Now();
    block.refusal.clear();
  }
  Q_EMIT dataChanged(index(row, 0), index(row, kColumnCount - 1));
  return position.block->column;
}

void ValuesModel::tick() {
  const SteadyTime before = std::exchange(ticked_, clock_.Now());
  const auto has_passed = [&](SteadyTime end) { return end > before && end <= ticked_; };
  const bool any = std::any_of(blocks_.begin(), blocks_.end(), [&](const Block& block) {
    if (!block.isKnown()) {
      return block.awaited != SteadyTime::max() && has_passed(block.awaited + kReplyTimeout);
    }
    return isOld(block) ||
           std::any_of(block.changed.begin(), block.changed.end(),
                       [&](SteadyTime changed) { return has_passed(changed + kFresh); });
  });
  if (any) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
}

void ValuesModel::show(const QString& path, const ComponentDescription* component,
                       StaleReason why) {
  std::vector<Block> fresh;
  if (component != nullptr) {
    for (const auto& table : component->tables) {
      const QString interface = path + '/' + ToQString(table.name);
      const QString prefix = table.name == "state" ? QString() : ToQString(table.name) + '.';
      for (const auto* column : ColumnsOf(table)) {
        const QString name = ToQString(column->name);
        fresh.push_back({.column = interface + '.' + name, .name = prefix + name});
      }
    }
  }
  if (fresh != blocks_) {
    beginResetModel();
    blocks_ = std::move(fresh);
    why_ = why;
    endResetModel();
  } else if (why != why_) {
    why_ = why;
    for (Block& block : blocks_) {  // the time limit for the reply starts again
      if (block.awaited != SteadyTime::max()) block.awaited = clock_.Now();
      block.refusal.clear();
    }
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumnCount - 1));
  }
}

QSet<QString> ValuesModel::columns() const {
  QSet<QString> columns;
  for (const Block& block : blocks_) columns.insert(block.column);
  return columns;
}

/// Records which values have changed. Values that arrive for the first time do not count.
void ValuesModel::noteChanges(Block& block, const ColumnValues& values) const {
  const auto& before = block.values.values;
  block.changed.resize(values.values.size());
  for (std::size_t field = 0; field < std::min(before.size(), values.values.size()); ++field) {
    if (before[field] != values.values[field]) block.changed[field] = clock_.Now();
  }
}

void ValuesModel::addToTrends(Block& block) {
  block.trends.resize(block.values.values.size());
  for (std::size_t field = 0; field < block.trends.size(); ++field) {
    QList<std::optional<NumericValue>>& trend = block.trends[field];
    trend.append(block.values.values[field]);
    if (trend.size() > kTrend) trend.removeFirst();
  }
}

void ValuesModel::replaceRows(Block& block, int first, const ColumnValues& values) {
  Block changed = block;
  changed.values = values;
  changed.trends.clear();
  changed.changed.clear();
  beginRemoveRows({}, first, first + block.rows() - 1);
  block.is_out = true;
  endRemoveRows();
  beginInsertRows({}, first, first + changed.rows() - 1);
  block = std::move(changed);
  endInsertRows();
}

void ValuesModel::showRefusal(const QString& column, const QString& reason) {
  int row = 0;
  for (Block& block : blocks_) {
    if (block.column == column && block.refusal != reason) {
      block.refusal = reason;
      Q_EMIT dataChanged(index(row, 0), index(row, kColumnCount - 1));
    }
    row += block.rows();
  }
}

void ValuesModel::showValues(const QString& column, const ColumnValues& values) {
  int first = 0;
  for (Block& block : blocks_) {
    if (block.column != column) {
      first += block.rows();
      continue;
    }
    if (block.values.fields == values.fields) {
      noteChanges(block, values);
      block.values = values;
    } else {
      replaceRows(block, first, values);
    }
    block.refusal.clear();
    block.arrived = clock_.Now();
    block.rate.onValues(values);
    addToTrends(block);
    const int last = first + block.rows() - 1;
    Q_EMIT dataChanged(index(first, 0), index(last, kColumnCount - 1));
    return;
  }
}

}  // namespace tendon::gui
