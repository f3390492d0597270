#include <gcm_gui/language/words.h>
#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/rate_badge.h>

#include <QRegularExpression>
#include <algorithm>

// The contents of the catalogue's cells.
namespace tendon::gui {
namespace {

const QString kNotKnown = QStringLiteral("–");

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
    case ItemKind::kChannel:
      return QStringLiteral("·");
    default:
      return {};
  }
}

Face FaceOf(ItemKind kind) {
  if (kind == ItemKind::kProcess) return Face::kStrong;
  return kind <= ItemKind::kRequired ? Face::kPlain : Face::kMono;
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
      return Words::tr("Rows per second that arrive here; – if nothing is subscribed");
    case CatalogueModel::kAge:
      return Words::tr(
          "Of a value: since its newest row was written. Of a process: since its state has "
          "changed. – if it is not known");
    case CatalogueModel::kConnected:
      return Words::tr("The connected interfaces; for a component, the connected components");
    default:
      return {};
  }
}

}  // namespace

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
    case kFaceRole:
      return static_cast<int>(FaceOf(item.kind));
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
  if (item.kind != ItemKind::kColumn && item.kind != ItemKind::kChannel) return item.value;
  const auto quantity = quantityOf(item);
  return quantity ? quantity->number : QString();
}

std::optional<Quantity> CatalogueModel::quantityOf(const CatalogueItem& item) const {
  if (item.kind != ItemKind::kColumn && item.kind != ItemKind::kChannel) return std::nullopt;
  const auto values = values_.constFind(columnFor(item)->path);
  if (values == values_.constEnd()) return std::nullopt;
  const bool scalar = values->channels->size() == 1 && item.children.empty();
  if (item.kind == ItemKind::kColumn && !scalar) return Quantity{values->text, item.unit};
  const auto channel = static_cast<std::size_t>(std::max(item.channel, 0));
  if (channel >= values->values.size()) return std::nullopt;
  return QuantityOf((*values->channels)[channel], values->values[channel]);
}

QString CatalogueModel::wholeText(const CatalogueItem& item) const {
  if (item.kind != ItemKind::kColumn && item.kind != ItemKind::kChannel) return {};
  const auto values = values_.constFind(columnFor(item)->path);
  const auto channel = static_cast<std::size_t>(std::max(item.channel, 0));
  if (values == values_.constEnd()) return {};
  const bool scalar = values->channels->size() == 1 && item.children.empty();
  if (item.kind == ItemKind::kColumn && !scalar) return values->text;
  if (channel >= values->values.size()) return {};
  return WholeText((*values->channels)[channel], values->values[channel]);
}

QString CatalogueModel::unitText(const CatalogueItem& item) const {
  const auto quantity = quantityOf(item);
  const QString unit = quantity ? quantity->unit : item.unit;
  const bool told_above = item.parent->kind == ItemKind::kGroup && item.parent->unit == unit;
  return told_above ? QString() : unit;
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

/// For an item with several columns, the highest rate.
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
  // Without a subscription, the age of a running component's values is unknown.
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
