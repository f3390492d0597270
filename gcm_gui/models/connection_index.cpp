#include <gcm_gui/models/connection_index.h>

namespace tendon::gui {

ConnectionIndex::ConnectionIndex(const Catalog& catalogue) {
  for (const auto& [name, entry] : catalogue.processes()) {
    for (const auto& [id, connection] : entry.connections) {
      by_required_[connection.required] = &connection;
      if (connection.state == ConnectionState::kActive) ++clients_[connection.provided];
    }
  }
}

const ConnectionDescription* ConnectionIndex::Of(const InterfaceName& required) const {
  const auto it = by_required_.find(required);
  return it == by_required_.end() ? nullptr : it->second;
}

int ConnectionIndex::Clients(const InterfaceName& provided) const {
  const auto it = clients_.find(provided);
  return it == clients_.end() ? 0 : it->second;
}

}  // namespace tendon::gui
