#include <gcm_gui/models/connections_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

bool ByRequired(const ConnectionDescription& a, const ConnectionDescription& b) {
  return a.required < b.required;
}

QString ConnectionStateText(const ConnectionDescription& connection) {
  const QString word = WordOf(MarkOf(connection.state));
  return connection.reason.empty() ? word
                                   : word + QStringLiteral(" · ") + ToQString(connection.reason);
}

}  // namespace

int ConnectionsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ConnectionsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

QVariant ConnectionsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  switch (section) {
    case kRequired:
      return Words::tr("Required");
    case kProvided:
      return Words::tr("Provided");
    default:
      return Words::tr("State");
  }
}

QVariant ConnectionsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ConnectionDescription& row = connection(index.row());
  const QString required = ToQString(ToString(row.required));
  const QString provided = ToQString(ToString(row.provided));
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == kRequired) return required;
      return index.column() == kProvided ? provided : ConnectionStateText(row);
    case kPathRole:
      return index.column() == kProvided ? provided : required;
    case kFontStyleRole:
      return static_cast<int>(index.column() == kState ? FontStyle::kPlain : FontStyle::kMono);
    case kStaleRole:
      return outdated_;
    case kGlyphMarkRole:
      return index.column() == kState ? QVariant::fromValue(MarkOf(row.state)) : QVariant();
    case Qt::ToolTipRole:
      return ToQString(row.reason);
    case Qt::AccessibleTextRole:
      return Words::tr("%1 from %2, %3").arg(required, provided, ConnectionStateText(row));
    default:
      return {};
  }
}

const ConnectionDescription& ConnectionsModel::connection(int row) const {
  return rows_.at(static_cast<std::size_t>(row));
}

int ConnectionsModel::rowOf(const QString& required) const {
  const auto it = std::find_if(rows_.begin(), rows_.end(), [&](const auto& row) {
    return ToQString(ToString(row.required)) == required;
  });
  return it == rows_.end() ? -1 : static_cast<int>(it - rows_.begin());
}

void ConnectionsModel::update(const Catalogue& catalogue) {
  std::vector<ConnectionDescription> fresh = catalogue.connections();
  std::sort(fresh.begin(), fresh.end(), ByRequired);
  for (std::size_t row = rows_.size(); row-- > 0;) {
    if (std::binary_search(fresh.begin(), fresh.end(), rows_[row], ByRequired)) continue;
    const auto place = static_cast<int>(row);
    beginRemoveRows({}, place, place);
    rows_.erase(rows_.begin() + place);
    endRemoveRows();
  }
  for (std::size_t row = 0; row < fresh.size(); ++row) {
    const auto place = static_cast<int>(row);
    if (row == rows_.size() || ByRequired(fresh[row], rows_[row])) {
      beginInsertRows({}, place, place);
      rows_.insert(rows_.begin() + place, std::move(fresh[row]));
      endInsertRows();
    } else if (rows_[row] != fresh[row]) {
      rows_[row] = std::move(fresh[row]);
      Q_EMIT dataChanged(index(place, 0), index(place, kColumnCount - 1));
    }
  }
}

void ConnectionsModel::setOutdated(bool outdated) {
  if (outdated == outdated_) return;
  outdated_ = outdated;
  if (rows_.empty()) return;
  Q_EMIT dataChanged(index(0, 0), index(static_cast<int>(rows_.size()) - 1, kColumnCount - 1));
}

}  // namespace tendon::gui
