#include <gcm_gui/inspector/component_connections.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_of.h>
#include <gcm_gui/models/text.h>

namespace tendon::gui {

ComponentConnections::ComponentConnections(ConnectionsModel& connections, QObject* parent)
    : QSortFilterProxyModel(parent), connections_(connections) {
  setSourceModel(&connections);
}

void ComponentConnections::setComponent(const std::string& process, const std::string& component) {
  const InterfaceName wanted{process, component, {}};
  if (wanted == component_) return;
  component_ = wanted;
  invalidateFilter();
}

bool ComponentConnections::isOwn(const InterfaceName& name) const {
  return name.process == component_.process && name.component == component_.component;
}

bool ComponentConnections::filterAcceptsRow(int row, const QModelIndex&) const {
  const ConnectionDescription& connection = connections_.connection(row);
  return isOwn(connection.required) || isOwn(connection.provided);
}

QVariant ComponentConnections::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto& connection = connections_.connection(mapToSource(index).row());
  const bool is_client = isOwn(connection.required);
  const InterfaceName& own = is_client ? connection.required : connection.provided;
  const InterfaceName& peer = is_client ? connection.provided : connection.required;
  switch (role) {
    case Qt::DisplayRole:
      return ToQString(own.interface);
    case kFaceRole:
      return static_cast<int>(Face::kStrong);
    case kDetailRole:
      return (is_client ? QStringLiteral("← ") : QStringLiteral("→ ")) +
             ToQString(peer.component + '/' + peer.interface);
    case kTrailRole:  // the usual state is told by its mark, to leave room for the name
      return connection.state == ConnectionState::kActive ? QString()
                                                          : WordOf(MarkOf(connection.state));
    case kGlyphMarkRole:
      return QVariant::fromValue(MarkOf(connection.state));
    case Qt::ToolTipRole:
    case kPathRole:
      return ToQString(ToString(peer));
    default:
      return QSortFilterProxyModel::data(index, role);
  }
}

}  // namespace tendon::gui
