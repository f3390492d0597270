#include <gcm_gui/connect/candidates_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {

CandidatesModel::CandidatesModel(const ConnectMode& mode, QObject* parent)
    : QAbstractItemModel(parent), mode_(mode) {
  connect(&mode, &ConnectMode::changed, this, &CandidatesModel::refresh);
  refresh();
}

void CandidatesModel::setFilter(const QString& words) {
  words_ = words.toLower().split(' ', Qt::SkipEmptyParts);
  refresh();
}

CandidatesModel::Row CandidatesModel::rowOf(const PortCandidate& candidate) {
  Row row;
  row.port = candidate.port;
  row.name = ToQString(ToString(candidate.port.name));
  row.fits = candidate.fits();
  row.stale = candidate.gone || !row.fits;
  if (candidate.number > 0) row.digit = QString::number(candidate.number);
  row.trail = Words::tr("%1 of %2")
                  .arg(candidate.compatibility.matched)
                  .arg(candidate.compatibility.needed);
  row.tip = row.name + Words::tr("\nHas %1 of the %2 commands and events that are needed.")
                           .arg(candidate.compatibility.matched)
                           .arg(candidate.compatibility.needed);
  if (candidate.gone) {
    row.trail = WordOf(StateMark::kLost);
  } else if (candidate.present) {
    row.trail = WordOf(StateMark::kConnected);
    row.mark = StateMark::kConnected;
  } else if (candidate.former) {
    row.trail = Words::tr("replaces %1").arg(ToQString(candidate.former->component));
  }
  if (!candidate.present) row.reasons = candidate.reasons();
  return row;
}

bool CandidatesModel::isWanted(const QString& name) const {
  return std::all_of(words_.begin(), words_.end(),
                     [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); });
}

void CandidatesModel::refresh() {
  std::vector<Row> fresh;
  int others = 0;
  int beyond = 0;
  for (const PortCandidate& candidate : mode_.candidates()) {
    if (!candidate.fits() && !candidate.present && !candidate.looksAlike() && words_.isEmpty()) {
      ++others;
    } else if (!isWanted(ToQString(ToString(candidate.port.name)))) {
      continue;
    } else if (fresh.size() == kMaxShown) {
      ++beyond;
    } else {
      fresh.push_back(rowOf(candidate));
    }
  }
  const auto add = [&fresh](const QString& text) {
    Row row;
    row.name = text;
    row.stale = true;
    fresh.push_back(std::move(row));
  };
  if (beyond > 0) add(Words::tr("%1 more: type a part of the name to find one").arg(beyond));
  if (others > 0) {
    add(fresh.empty() ? Words::tr("None of %1 fits").arg(others)
                      : Words::tr("%1 more do not fit").arg(others));
  }
  if (fresh == rows_) return;
  beginResetModel();
  rows_ = std::move(fresh);
  endResetModel();
}

const CandidatesModel::Row& CandidatesModel::row(const QModelIndex& index) const {
  const auto place = isReason(index) ? index.internalId() - 1 : static_cast<quintptr>(index.row());
  return rows_.at(place);
}

std::optional<PortName> CandidatesModel::portOf(const QModelIndex& index) const {
  return index.isValid() ? row(index).port : std::nullopt;
}

bool CandidatesModel::fits(const QModelIndex& index) const {
  return index.isValid() && row(index).fits;
}

QModelIndex CandidatesModel::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column,
                     parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : quintptr{0});
}

QModelIndex CandidatesModel::parent(const QModelIndex& index) const {
  if (!index.isValid() || !isReason(index)) return {};
  return createIndex(static_cast<int>(index.internalId() - 1), 0, quintptr{0});
}

int CandidatesModel::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(rows_.size());
  return isReason(parent) ? 0 : static_cast<int>(row(parent).reasons.size());
}

Qt::ItemFlags CandidatesModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::NoItemFlags;
  const bool choice = !isReason(index) && row(index).port.has_value();
  return choice ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::ItemIsEnabled;
}

QVariant CandidatesModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = this->row(index);
  if (isReason(index)) {
    const bool text = role == Qt::DisplayRole || role == Qt::AccessibleTextRole;
    return text ? QVariant(row.reasons.at(index.row())) : QVariant();
  }
  const bool choice = row.port.has_value();
  switch (role) {
    case Qt::DisplayRole:
      return row.name;
    case Qt::ToolTipRole:
      return choice ? row.tip : QVariant();
    case kPathRole:
      return choice ? row.name : QString();
    case kFontStyleRole:
      return static_cast<int>(choice ? FontStyle::kMono : FontStyle::kPlain);
    case kGlyphRole:
      return row.digit;
    case kAccentRole:
      return row.fits;
    case kGlyphMarkRole:
      return row.fits || !choice ? QVariant() : QVariant::fromValue(row.mark);
    case kTrailRole:
      return row.trail;
    case kStaleRole:
      return row.stale;
    case Qt::AccessibleTextRole:
      return QStringList{row.name, row.trail, row.fits ? Words::tr("fits") : QString()}
          .join(' ')
          .simplified();
    default:
      return {};
  }
}

}  // namespace tendon::gui
