#include <gcm_gui/models/catalogue_filter.h>

#include <algorithm>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kTypingPause{120};

/// Returns the parent of an item; null for a process.
const CatalogueItem* Above(const CatalogueItem& item) {
  return item.parent->parent == nullptr ? nullptr : item.parent;
}

int CountMatches(const FilterExpression& expression, const CatalogueItem& item) {
  int count = expression.Matches(item) ? 1 : 0;
  for (const auto& child : item.children) count += CountMatches(expression, *child);
  return count;
}

}  // namespace

CatalogueFilter::CatalogueFilter(CatalogueModel& model, QObject* parent)
    : QAbstractProxyModel(parent), model_(model) {
  setSourceModel(&model);
  connectModel();
  typing_.setSingleShot(true);
  typing_.setInterval(kTypingPause);
  connect(&typing_, &QTimer::timeout, this, [this] { applyText(pending_); });
}

void CatalogueFilter::connectModel() {
  const auto child = [this](const QModelIndex& above, int row) -> const CatalogueItem& {
    return *model_.item(model_.index(row, 0, above));
  };
  connect(&model_, &QAbstractItemModel::rowsAboutToBeInserted, this,
          [this](const QModelIndex& above, int first, int last) {
            if (!active()) beginInsertRows(mapFromSource(above), first, last);
          });
  connect(&model_, &QAbstractItemModel::rowsInserted, this,
          [this, child](const QModelIndex& above, int first, int last) {
            if (!active()) return endInsertRows();
            matches_.reset();
            for (int row = first; row <= last; ++row) takeIn(child(above, row));
          });
  connect(&model_, &QAbstractItemModel::rowsAboutToBeRemoved, this,
          [this, child](const QModelIndex& above, int first, int last) {
            if (!active()) return beginRemoveRows(mapFromSource(above), first, last);
            matches_.reset();
            for (int row = first; row <= last; ++row) takeOut(child(above, row));
          });
  connect(&model_, &QAbstractItemModel::rowsRemoved, this, [this] {
    if (!active()) endRemoveRows();
  });
  connect(&model_, &QAbstractItemModel::dataChanged, this, &CatalogueFilter::onDataChanged);
}

void CatalogueFilter::onDataChanged(const QModelIndex& first, const QModelIndex& last,
                                    const QList<int>& roles) {
  if (!active()) return Q_EMIT dataChanged(mapFromSource(first), mapFromSource(last), roles);
  for (int row = first.row(); row <= last.row(); ++row) {
    // A signal with roles means that only values have changed, and no filter depends on values.
    if (roles.isEmpty()) recheck(*model_.item(first.siblingAtRow(row).siblingAtColumn(0)));
  }
  // One signal for the whole range is enough, because the visible rows are adjacent. The model does
  // the same.
  QModelIndex from;
  QModelIndex to;
  for (int row = first.row(); row <= last.row(); ++row) {
    const QModelIndex index = mapFromSource(first.siblingAtRow(row));
    if (!index.isValid()) continue;
    if (!from.isValid()) from = index;
    to = index.siblingAtColumn(last.column());
  }
  if (from.isValid()) Q_EMIT dataChanged(from, to, roles);
}

int CatalogueFilter::matchCount() const {
  if (!active()) return model_.itemCount();
  if (matches_) return *matches_;
  int count = 0;
  for (int row = 0; row < model_.rowCount({}); ++row) {
    count += CountMatches(expression_, *model_.item(model_.index(row, 0, {})));
  }
  return count;
}

QModelIndex CatalogueFilter::indexOf(const QString& path) const {
  return mapFromSource(model_.indexOf(path));
}

const CatalogueItem* CatalogueFilter::item(const QModelIndex& index) const {
  return index.isValid() ? static_cast<const CatalogueItem*>(index.constInternalPointer())
                         : nullptr;
}

void CatalogueFilter::setText(const QString& text) {
  pending_ = text;
  typing_.start();
}

void CatalogueFilter::applyText(const QString& text) {
  typing_.stop();
  pending_ = text;
  const FilterExpression expression(text);
  if (active() || !expression.empty()) {
    beginResetModel();
    expression_ = expression;
    collectAll();
    endResetModel();
  }
  Q_EMIT filterApplied();
}

void CatalogueFilter::collectAll() {
  shown_.clear();
  matches_ = 0;
  if (!active()) return;
  Rows processes;
  for (int row = 0; row < model_.rowCount({}); ++row) {
    const CatalogueItem* process = model_.item(model_.index(row, 0, {}));
    if (collect(*process, shown_, *matches_)) processes.push_back(process);
  }
  shown_[nullptr] = std::move(processes);
}

bool CatalogueFilter::collect(const CatalogueItem& item, Shown& shown, int& meant) const {
  Rows rows;
  for (const auto& child : item.children) {
    if (collect(*child, shown, meant)) rows.push_back(child.get());
  }
  const bool is_meant = expression_.Matches(item);
  if (is_meant) ++meant;
  if (rows.empty()) return is_meant;
  shown.insert_or_assign(&item, std::move(rows));
  return true;
}

/// Shows a new item that matches, and all its parents that are not shown yet.
void CatalogueFilter::takeIn(const CatalogueItem& item) {
  int meant = 0;
  if (!collect(item, shown_, meant)) return;
  const CatalogueItem* top = &item;
  while (Above(*top) != nullptr && !isShown(*Above(*top))) {
    shown_[Above(*top)] = {top};
    top = Above(*top);
  }
  Rows& rows = shown_[Above(*top)];
  const auto place =
      std::lower_bound(rows.begin(), rows.end(), top->row,
                       [](const CatalogueItem* other, int row) { return other->row < row; });
  const auto row = static_cast<int>(place - rows.begin());
  beginInsertRows(indexFor(Above(*top)), row, row);
  rows.insert(place, top);
  endInsertRows();
}

/// Hides a removed item, and the parents that were shown only because of it.
void CatalogueFilter::takeOut(const CatalogueItem& item) {
  if (!isShown(item)) return;
  const CatalogueItem* top = &item;
  while (Above(*top) != nullptr && below(Above(*top)).size() == 1 &&
         !expression_.Matches(*Above(*top))) {
    top = Above(*top);
  }
  const int row = rowOf(*top);
  const CatalogueItem* above = Above(*top);
  beginRemoveRows(indexFor(above), row, row);
  Rows& rows = shown_[above];
  rows.erase(rows.begin() + row);
  if (rows.empty() && above != nullptr) shown_.erase(above);
  drop(*top);
  endRemoveRows();
}

void CatalogueFilter::drop(const CatalogueItem& item) {
  const auto known = shown_.find(&item);
  if (known == shown_.end()) return;
  const Rows rows = std::move(known->second);
  shown_.erase(known);
  for (const CatalogueItem* row : rows) drop(*row);
}

/// After a change, checks again whether an item and the rows below it match the filter.
void CatalogueFilter::recheck(const CatalogueItem& item) {
  matches_.reset();
  Shown now;
  int meant = 0;
  const bool is_shown = collect(item, now, meant);
  const auto is_as_before = [this](const auto& entry) {
    return below(entry.first) == entry.second;
  };
  if (is_shown == isShown(item) && parentsIn(item) == now.size() &&
      std::all_of(now.begin(), now.end(), is_as_before)) {
    return;
  }
  takeOut(item);
  takeIn(item);
}

std::size_t CatalogueFilter::parentsIn(const CatalogueItem& item) const {
  const Rows& rows = below(&item);
  std::size_t count = rows.empty() ? 0 : 1;
  for (const CatalogueItem* row : rows) count += parentsIn(*row);
  return count;
}

const CatalogueFilter::Rows& CatalogueFilter::below(const CatalogueItem* item) const {
  static const Rows kNone;
  const auto known = shown_.find(item);
  return known == shown_.end() ? kNone : known->second;
}

bool CatalogueFilter::isShown(const CatalogueItem& item) const {
  return !active() || rowOf(item) >= 0;
}

int CatalogueFilter::rowOf(const CatalogueItem& item) const {
  if (!active()) return item.row;
  const Rows& rows = below(Above(item));
  const auto place =
      std::lower_bound(rows.begin(), rows.end(), item.row,
                       [](const CatalogueItem* other, int row) { return other->row < row; });
  return place != rows.end() && *place == &item ? static_cast<int>(place - rows.begin()) : -1;
}

QModelIndex CatalogueFilter::indexFor(const CatalogueItem* item, int column) const {
  if (item == nullptr) return {};
  const int row = rowOf(*item);
  return row < 0 ? QModelIndex() : createIndex(row, column, item);
}

QModelIndex CatalogueFilter::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  const CatalogueItem* above = item(parent);
  if (active()) return createIndex(row, column, below(above)[static_cast<std::size_t>(row)]);
  return createIndex(row, column,
                     above == nullptr ? model_.item(model_.index(row, 0, {}))
                                      : above->children[static_cast<std::size_t>(row)].get());
}

QModelIndex CatalogueFilter::parent(const QModelIndex& index) const {
  return index.isValid() ? indexFor(Above(*item(index))) : QModelIndex();
}

int CatalogueFilter::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  const CatalogueItem* above = item(parent);
  if (active()) return static_cast<int>(below(above).size());
  return above == nullptr ? model_.rowCount({}) : static_cast<int>(above->children.size());
}

bool CatalogueFilter::hasChildren(const QModelIndex& parent) const { return rowCount(parent) > 0; }

int CatalogueFilter::columnCount(const QModelIndex&) const { return CatalogueModel::kColumnCount; }

QModelIndex CatalogueFilter::mapToSource(const QModelIndex& index) const {
  const CatalogueItem* here = item(index);
  if (here == nullptr) return {};
  return createSourceIndex(here->row, index.column(), const_cast<CatalogueItem*>(here));
}

QModelIndex CatalogueFilter::mapFromSource(const QModelIndex& index) const {
  const CatalogueItem* here = model_.item(index);
  if (here == nullptr) return {};
  // The index is valid only if all parents are shown as well.
  for (const CatalogueItem* above = here; above != nullptr; above = Above(*above)) {
    if (!isShown(*above)) return {};
  }
  return indexFor(here, index.column());
}

QVariant CatalogueFilter::headerData(int section, Qt::Orientation orientation, int role) const {
  return model_.headerData(section, orientation, role);
}

}  // namespace tendon::gui
