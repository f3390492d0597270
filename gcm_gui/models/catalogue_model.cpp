#include <gcm_gui/models/catalogue_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/controls/rate_badge.h>

#include <QMimeData>
#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <tuple>
#include <utility>

namespace tendon::gui {
namespace {

constexpr auto kLast = CatalogueModel::kConnected;
constexpr std::int64_t kFresh = 10'000'000'000;  // ns
const QString kNotKnown = QStringLiteral("–");

bool IsSame(const CatalogueItem& a, const CatalogueItem& b) {
  return a.kind == b.kind && a.path == b.path;
}

/// Copies the data of the row itself from `fresh`. Returns false if nothing has changed.
bool TakeOver(CatalogueItem& item, const CatalogueItem& fresh) {
  const auto all = [](auto& i) {
    return std::tie(i.name, i.detail, i.value, i.unit, i.connected, i.mark, i.state, i.gone,
                    i.still, i.host, i.since, i.type, i.field);
  };
  if (all(item) == all(fresh)) return false;
  all(item) = all(fresh);
  return true;
}

void Renumber(CatalogueItem& parent, std::size_t from) {
  for (std::size_t row = from; row < parent.children.size(); ++row) {
    parent.children[row]->row = static_cast<int>(row);
  }
}

void CollectSignals(const CatalogueItem& item, QList<CurveKey>& names) {
  if (item.kind == ItemKind::kField) names.append({item.path, item.unit});
  for (const auto& child : item.children) CollectSignals(*child, names);
}

QString Glyph(ItemKind kind) {
  switch (kind) {
    case ItemKind::kCommand:
    case ItemKind::kFunction:
      return QStringLiteral("ƒ");
    case ItemKind::kEvent:
    case ItemKind::kHandler:
      return QStringLiteral("⚡");
    case ItemKind::kColumn:
      return QStringLiteral("~");
    case ItemKind::kGroup:
    case ItemKind::kField:
      return QStringLiteral("·");
    default:
      return {};
  }
}

FontStyle FontStyleOf(ItemKind kind) {
  if (kind == ItemKind::kProcess) return FontStyle::kStrong;
  return kind <= ItemKind::kRequired ? FontStyle::kPlain : FontStyle::kMono;
}

QString ColumnTitle(int column) {
  switch (column) {
    case CatalogueModel::kValue:
      return Words::tr("State / value");
    case CatalogueModel::kRate:
      return Words::tr("Rate");
    case CatalogueModel::kAge:
      return Words::tr("Age");
    case CatalogueModel::kConnected:
      return Words::tr("Connected to");
    default:
      return Words::tr("Name");
  }
}

QString ExplanationOf(int column) {
  switch (column) {
    case CatalogueModel::kRate:
      return Words::tr("Rows per second that arrive in this window. “–” means no subscription");
    case CatalogueModel::kAge:
      return Words::tr(
          "For a value: time since its newest row was written. For a process: time since its state "
          "changed. “–” means unknown");
    case CatalogueModel::kConnected:
      return Words::tr("The connected interfaces; for a component, the connected components");
    default:
      return {};
  }
}

}  // namespace

CatalogueModel::CatalogueModel(QObject* parent, const Clock& clock)
    : QAbstractItemModel(parent),
      root_(std::make_unique<CatalogueItem>()),
      clock_(clock),
      arrivals_(clock) {}

CatalogueModel::~CatalogueModel() = default;

QModelIndex CatalogueModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, itemFor(parent).children[static_cast<std::size_t>(row)].get());
}

QModelIndex CatalogueModel::parent(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  return indexFor(*itemFor(index).parent);
}

int CatalogueModel::rowCount(const QModelIndex& parent) const {
  if (parent.column() > 0) return 0;
  return static_cast<int>(itemFor(parent).children.size());
}

int CatalogueModel::columnCount(const QModelIndex&) const { return kColumnCount; }

Qt::ItemFlags CatalogueModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (itemFor(index).kind >= ItemKind::kColumn) flags |= Qt::ItemIsDragEnabled;
  return flags;
}

QStringList CatalogueModel::mimeTypes() const { return {kPathMimeType}; }

QMimeData* CatalogueModel::mimeData(const QModelIndexList& indexes) const {
  QList<CurveKey> keys;
  for (const QModelIndex& index : indexes) {
    if (index.column() == kName) keys.append(signalsBelow(itemFor(index).path));
  }
  auto* data = new QMimeData;
  SetPaths(*data, keys);
  return data;
}

QModelIndex CatalogueModel::indexOf(const QString& path) const {
  const CatalogueItem* item = by_path_.value(path);
  return item == nullptr ? QModelIndex() : indexFor(*item);
}

const CatalogueItem* CatalogueModel::item(const QModelIndex& index) const {
  return index.isValid() ? &itemFor(index) : nullptr;
}

int CatalogueModel::itemCount() const {
  return static_cast<int>(std::count_if(by_path_.begin(), by_path_.end(), [](const auto* item) {
    return item->kind <= ItemKind::kColumn;
  }));
}

QList<CurveKey> CatalogueModel::signalsBelow(const QString& path) const {
  QList<CurveKey> names;
  const CatalogueItem* item = by_path_.value(path);
  if (item == nullptr) return names;
  CollectSignals(*item, names);
  const auto values = values_.constFind(path);
  if (names.isEmpty() && values != values_.constEnd() && values->fields->size() == 1) {
    names.append({path, ToQString(values->fields->front().unit)});
  }
  return names;
}

StaleReason CatalogueModel::standstill(const QString& path) const {
  const CatalogueItem* component = by_path_.value(path.section('/', 0, 1));
  return component == nullptr ? StaleReason::kNone : standstillOf(*component);
}

QString CatalogueModel::columnOf(const QModelIndex& index) const {
  if (!index.isValid()) return {};
  const CatalogueItem* column = columnFor(itemFor(index));
  return column == nullptr ? QString() : column->path;
}

const CatalogueItem* CatalogueModel::columnFor(const CatalogueItem& item) const {
  const CatalogueItem* column = &item;
  while (column != nullptr && column->kind != ItemKind::kColumn) column = column->parent;
  return column;
}

QModelIndex CatalogueModel::indexFor(const CatalogueItem& item, int column) const {
  if (&item == root_.get()) return {};
  return createIndex(item.row, column, &item);
}

const CatalogueItem& CatalogueModel::itemFor(const QModelIndex& index) const {
  return index.isValid() ? *static_cast<const CatalogueItem*>(index.constInternalPointer())
                         : *root_;
}

void CatalogueModel::update(const Catalogue& catalogue, const ChangedParts& touched) {
  const ConnectionIndex connections(catalogue);
  const std::string* whole = nullptr;
  for (const ChangedPart& part : touched) {  // a process comes before its components
    if (whole != nullptr && part.process == *whole) continue;
    if (part.component.empty()) {
      updateProcess(catalogue, connections, part.process);
      whole = &part.process;
    } else {
      updateComponent(catalogue, connections, part);
    }
  }
}

void CatalogueModel::updateProcess(const Catalogue& catalogue, const ConnectionIndex& connections,
                                   const std::string& name) {
  const ProcessEntry* entry = catalogue.FindProcess(name);
  const QString path = ToQString(name);
  auto& processes = root_->children;
  const auto place = std::lower_bound(processes.begin(), processes.end(), path,
                                      [](const auto& a, const QString& b) { return a->path < b; });
  const auto row = static_cast<int>(place - processes.begin());
  const bool known = place != processes.end() && (*place)->path == path;
  if (entry == nullptr) {
    if (known) removeChild(*root_, row);
    return;
  }
  auto fresh = BuildProcess(connections, *entry);
  if (known) {
    merge(**place, *fresh);
  } else {
    insertChild(*root_, row, std::move(fresh));
  }
}

void CatalogueModel::updateComponent(const Catalogue& catalogue, const ConnectionIndex& connections,
                                     const ChangedPart& part) {
  const ProcessEntry* entry = catalogue.FindProcess(part.process);
  CatalogueItem* process = by_path_.value(ToQString(part.process));
  if (entry == nullptr || process == nullptr)
    return updateProcess(catalogue, connections, part.process);
  const auto it = entry->components.find(part.component);
  const QString path = ToQString(part.process + '/' + part.component);
  auto& components = process->children;
  const auto place = std::find_if(components.begin(), components.end(),
                                  [&](const auto& c) { return c->path >= path; });
  const auto row = static_cast<int>(place - components.begin());
  const bool known = place != components.end() && (*place)->path == path;
  if (it == entry->components.end()) {
    if (known) removeChild(*process, row);
    return;
  }
  auto fresh = BuildComponent(connections, *entry, it->second);
  if (known) {
    merge(**place, *fresh);
  } else {
    insertChild(*process, row, std::move(fresh));
  }
}

void CatalogueModel::merge(CatalogueItem& item, CatalogueItem& fresh) {
  const bool same_type = item.type == fresh.type;
  if (item.kind == ItemKind::kColumn && same_type) fresh.unit = item.unit;
  if (TakeOver(item, fresh)) Q_EMIT dataChanged(indexFor(item), indexFor(item, kLast));
  if (item.kind == ItemKind::kColumn && same_type && fresh.children.empty()) {
    for (const auto& child : item.children) setGone(*child, item.gone);
    return;
  }
  if (item.kind == ItemKind::kColumn && !same_type) {
    values_.remove(item.path);
    arrivals_.forget(item.path);
  }
  mergeChildren(item, std::move(fresh.children));
}

void CatalogueModel::mergeChildren(CatalogueItem& parent,
                                   std::vector<std::unique_ptr<CatalogueItem>> fresh) {
  QSet<QString> wanted;
  for (const auto& child : fresh) wanted.insert(child->path);
  for (auto row = static_cast<int>(parent.children.size()); row-- > 0;) {
    if (!wanted.contains(parent.children[static_cast<std::size_t>(row)]->path)) {
      removeChild(parent, row);
    }
  }
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    const auto& children = parent.children;
    const CatalogueItem* known = by_path_.value(fresh[row]->path);
    // If the known row has moved, it is removed here and inserted again at its new position.
    while (known != nullptr && known->parent == &parent && children[row].get() != known) {
      removeChild(parent, static_cast<int>(row));
    }
    if (row < children.size() && IsSame(*children[row], *fresh[row])) {
      merge(*children[row], *fresh[row]);
    } else {
      insertChild(parent, static_cast<int>(row), std::move(fresh[row]));
    }
  }
  while (parent.children.size() > fresh.size()) {
    removeChild(parent, static_cast<int>(parent.children.size()) - 1);
  }
}

void CatalogueModel::insertChild(CatalogueItem& parent, int row,
                                 std::unique_ptr<CatalogueItem> child) {
  beginInsertRows(indexFor(parent), row, row);
  child->parent = &parent;
  enter(*child);
  parent.children.insert(parent.children.begin() + row, std::move(child));
  Renumber(parent, static_cast<std::size_t>(row));
  markFresh(*parent.children[static_cast<std::size_t>(row)]);
  endInsertRows();
}

void CatalogueModel::removeChild(CatalogueItem& parent, int row) {
  beginRemoveRows(indexFor(parent), row, row);
  const auto place = parent.children.begin() + row;
  forget(**place);
  parent.children.erase(place);
  Renumber(parent, static_cast<std::size_t>(row));
  endRemoveRows();
}

void CatalogueModel::setGone(CatalogueItem& item, bool gone) {
  if (item.gone == gone) return;
  item.gone = gone;
  Q_EMIT dataChanged(indexFor(item), indexFor(item, kLast));
  for (const auto& child : item.children) setGone(*child, gone);
}

void CatalogueModel::enter(CatalogueItem& item) {
  by_path_.insert(item.path, &item);
  for (const auto& child : item.children) enter(*child);
}

void CatalogueModel::forget(CatalogueItem& item) {
  for (const auto& child : item.children) forget(*child);
  values_.remove(item.path);
  arrivals_.forget(item.path);
  if (by_path_.value(item.path) == &item) by_path_.remove(item.path);
}

void CatalogueModel::showValues(const QString& column, const ColumnValues& values) {
  CatalogueItem* item = by_path_.value(column);
  if (item == nullptr || item->kind != ItemKind::kColumn) return;
  const auto known = values_.constFind(column);
  const bool same_shape = known != values_.constEnd() && known->fields == values.fields;
  values_.insert(column, values);
  arrivals_.onValues(column, values);
  if (!same_shape) mergeChildren(*item, BuildFieldItems(*item, *values.fields));
  if (!same_shape && values.fields->size() == 1 && item->children.empty()) {
    item->unit = ToQString(values.fields->front().unit);
  }
  emitValuesChanged(*item);
}

void CatalogueModel::emitValuesChanged(CatalogueItem& item) {
  if (item.kind == ItemKind::kColumn)
    Q_EMIT dataChanged(indexFor(item, kValue), indexFor(item, kAge), {Qt::DisplayRole});
  if (item.children.empty()) return;
  Q_EMIT dataChanged(indexFor(*item.children.front(), kValue),
                     indexFor(*item.children.back(), kAge), {Qt::DisplayRole});
  for (const auto& child : item.children) {
    if (!child->children.empty()) emitValuesChanged(*child);
  }
}

/// Marks a new row. Rows that arrive soon after the first rows are not marked: a GCM that was
/// restarted sends all rows again.
void CatalogueModel::markFresh(const CatalogueItem& item) {
  if (begun_ == 0) begun_ = now_;
  if (outdated_ || now_ < begun_ + kFresh || item.kind >= ItemKind::kColumn) return;
  fresh_.insert(item.path, now_ + kFresh);
}

void CatalogueModel::dropFresh() {
  const QHash<QString, std::int64_t> all = fresh_;
  for (auto it = all.begin(); it != all.end(); ++it) {
    if (now_ < it.value()) continue;
    fresh_.remove(it.key());
    const QModelIndex name = indexOf(it.key());
    if (name.isValid()) Q_EMIT dataChanged(name, name, {kFreshRole});
  }
}

void CatalogueModel::setNow(qint64 now) {
  now_ = now;
  dropFresh();
  for (const QString& column : arrivals_.dropSilent()) {
    if (CatalogueItem* item = by_path_.value(column)) emitValuesChanged(*item);
  }
  if (root_->children.empty()) return;
  Q_EMIT dataChanged(indexFor(*root_->children.front(), kValue),
                     indexFor(*root_->children.back(), kAge), {Qt::DisplayRole});
}

void CatalogueModel::setOutdated(bool outdated) {
  if (outdated == outdated_) return;
  outdated_ = outdated;
  if (!outdated) begun_ = now_;
  // Qt redraws all visible rows, regardless of the range in the signal.
  if (root_->children.empty()) return;
  Q_EMIT dataChanged(indexFor(*root_->children.front()), indexFor(*root_->children.back(), kLast));
}

// The following functions return the contents of the cells.

QVariant CatalogueModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  switch (role) {
    case Qt::DisplayRole:
      return ColumnTitle(section);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return ExplanationOf(section);
    case Qt::TextAlignmentRole: {
      const bool is_left = section == kName || section == kConnected;
      return static_cast<int>(Qt::AlignVCenter | (is_left ? Qt::AlignLeft : Qt::AlignRight));
    }
    default:
      return {};
  }
}

QVariant CatalogueModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const CatalogueItem& item = itemFor(index);
  switch (role) {
    case kPathRole:
      return item.path;
    case kKindRole:
      return static_cast<int>(item.kind);
    case kStaleRole:
      return item.gone || (outdated_ && item.kind < ItemKind::kColumn) ||
             !oldTextOf(item).isEmpty();
    case Qt::ToolTipRole:
      if (index.column() == kConnected && item.connected) return factText(item, kConnected);
      return QStringList{item.path, index.column() == kValue ? wholeText(item) : QString(),
                         item.detail, oldTextOf(item)}
          .join('\n')
          .replace(QRegularExpression(QStringLiteral("\n+")), QStringLiteral("\n"))
          .trimmed();
    case Qt::AccessibleTextRole:
      return spokenText(item, index.column());
    default:
      break;
  }
  switch (index.column()) {
    case kName:
      return nameData(item, role);
    case kValue:
      return valueData(item, role);
    default:
      return factData(item, index.column(), role);
  }
}

QVariant CatalogueModel::nameData(const CatalogueItem& item, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      return item.name;
    case kGlyphRole:
      return Glyph(item.kind);
    case kDetailRole:
      return item.kind == ItemKind::kColumn ? oldTextOf(item) : QString();
    case kGlyphMarkRole:
      if (item.kind == ItemKind::kProvided) return QVariant::fromValue(StateMark::kConnected);
      return item.kind == ItemKind::kRequired ? QVariant::fromValue(*item.mark) : QVariant();
    case kFontStyleRole:
      return static_cast<int>(FontStyleOf(item.kind));
    case kStruckRole:
      return item.kind <= ItemKind::kComponent && item.gone;
    case kFreshRole:
      return fresh_.contains(item.path);
    default:
      return {};
  }
}

QVariant CatalogueModel::valueData(const CatalogueItem& item, int role) const {
  const bool required = item.kind == ItemKind::kRequired;
  switch (role) {
    case Qt::DisplayRole:
      return valueText(item);
    case kMarkRole:
      return required || !item.mark ? QVariant() : QVariant::fromValue(*item.mark);
    case kUnitRole:
      return unitText(item);
    case kQuietRole:
      return item.kind < ItemKind::kColumn;
    case kAccentRole:
      return required && item.mark == StateMark::kNotConnected && !item.gone && !outdated_;
    case kProseRole:
      return item.kind <= ItemKind::kRequired && item.kind != ItemKind::kComponent;
    default:
      return {};
  }
}

QString CatalogueModel::valueText(const CatalogueItem& item) const {
  if (item.kind == ItemKind::kProcess && item.gone) {
    return item.value + ' ' + AgeText(now_ - item.since);
  }
  if (item.kind != ItemKind::kColumn && item.kind != ItemKind::kField) return item.value;
  const auto quantity = quantityOf(item);
  return quantity ? quantity->number : QString();
}

std::optional<Quantity> CatalogueModel::quantityOf(const CatalogueItem& item) const {
  if (item.kind != ItemKind::kColumn && item.kind != ItemKind::kField) return std::nullopt;
  const auto values = values_.constFind(columnFor(item)->path);
  if (values == values_.constEnd()) return std::nullopt;
  const bool scalar = values->fields->size() == 1 && item.children.empty();
  if (item.kind == ItemKind::kColumn && !scalar) return Quantity{values->text, item.unit};
  const auto field = static_cast<std::size_t>(std::max(item.field, 0));
  if (field >= values->values.size()) return std::nullopt;
  return QuantityOf((*values->fields)[field], values->values[field]);
}

QString CatalogueModel::wholeText(const CatalogueItem& item) const {
  if (item.kind != ItemKind::kColumn && item.kind != ItemKind::kField) return {};
  const auto values = values_.constFind(columnFor(item)->path);
  const auto field = static_cast<std::size_t>(std::max(item.field, 0));
  if (values == values_.constEnd()) return {};
  const bool scalar = values->fields->size() == 1 && item.children.empty();
  if (item.kind == ItemKind::kColumn && !scalar) return values->text;
  if (field >= values->values.size()) return {};
  return WholeText((*values->fields)[field], values->values[field]);
}

QString CatalogueModel::unitText(const CatalogueItem& item) const {
  const auto quantity = quantityOf(item);
  const QString unit = quantity ? quantity->unit : item.unit;
  const bool is_shown_above = item.parent->kind == ItemKind::kGroup && item.parent->unit == unit;
  return is_shown_above ? QString() : unit;
}

QVariant CatalogueModel::factData(const CatalogueItem& item, int column, int role) const {
  switch (role) {
    case Qt::DisplayRole:
      return factText(item, column);
    case kQuietRole:
      return column != kConnected || item.connected.value_or(QString()).isEmpty();
    case kLeftRole:
      return column == kConnected;
    default:
      return {};
  }
}

QString CatalogueModel::factText(const CatalogueItem& item, int column) const {
  if (column == kRate) {
    const auto rate = rateOf(item);
    return rate ? RateText(*rate) : kNotKnown;
  }
  if (column == kAge) {
    const auto age = ageOf(item);
    return age ? AgeText(*age) : kNotKnown;
  }
  if (!item.connected) return kNotKnown;
  return item.connected->isEmpty() ? Words::tr("nothing") : *item.connected;
}

/// Returns the rate of an item; if it contains several columns, the highest rate.
std::optional<double> CatalogueModel::rateOf(const CatalogueItem& item) const {
  if (item.gone || standstillOf(item) != StaleReason::kNone) return std::nullopt;
  if (item.kind >= ItemKind::kColumn) return arrivals_.rate(columnFor(item)->path);
  std::optional<double> fastest;
  if (item.kind != ItemKind::kComponent && item.kind != ItemKind::kProvided) return fastest;
  for (const auto& child : item.children) fastest = std::max(fastest, rateOf(*child));
  return fastest;
}

std::optional<std::int64_t> CatalogueModel::ageOf(const CatalogueItem& item) const {
  if (item.kind == ItemKind::kProcess && item.since > 0) return now_ - item.since;
  if (item.kind < ItemKind::kColumn) return std::nullopt;
  if (standstillOf(item) == StaleReason::kNone) return arrivals_.age(columnFor(item)->path);
  const auto age = rowAgeOf(item);
  return age ? std::optional(age->count()) : std::nullopt;
}

StaleReason CatalogueModel::standstillOf(const CatalogueItem& item) {
  const CatalogueItem* component = &item;
  while (component != nullptr && component->kind != ItemKind::kComponent) {
    component = component->parent;
  }
  return component == nullptr ? StaleReason::kNone : component->still;
}

std::optional<std::chrono::nanoseconds> CatalogueModel::rowAgeOf(const CatalogueItem& item) const {
  const auto values = values_.constFind(columnFor(item)->path);
  if (values == values_.constEnd() || values->time == 0) return std::nullopt;
  const std::chrono::nanoseconds now = clock_.Now().time_since_epoch();
  return std::max(std::chrono::nanoseconds(0), now - std::chrono::nanoseconds(values->time));
}

QString CatalogueModel::oldTextOf(const CatalogueItem& item) const {
  if (item.kind < ItemKind::kColumn) return {};
  const CatalogueItem& column = *columnFor(item);
  if (!values_.contains(column.path)) return {};
  const StaleReason why = standstillOf(item);
  // If a running component has no subscription, the age of its values is unknown.
  const auto age =
      why == StaleReason::kNone && !arrivals_.age(column.path) ? std::nullopt : rowAgeOf(item);
  return IsStale(why, age, arrivals_.usualRate(column.path)) ? OldText(why, age) : QString();
}

QString CatalogueModel::spokenText(const CatalogueItem& item, int column) const {
  if (column <= kValue) {
    QStringList words{item.name, KindWord(item.kind), valueText(item)};
    if (const QString old = oldTextOf(item); !old.isEmpty()) words.append(old);
    return words.join(QStringLiteral(", "));
  }
  const QString text = factText(item, column);
  return ColumnTitle(column) + QStringLiteral(": ") +
         (text == kNotKnown ? Words::tr("not known") : text);
}

}  // namespace tendon::gui
