#include <gcm_gui/models/connection_index.h>

#include <algorithm>

namespace tendon::gui {

ConnectionIndex::ConnectionIndex(const Catalogue& catalogue) {
  for (const auto& [name, entry] : catalogue.processes()) {
    for (const auto& [id, connection] : entry.connections) {
      by_required_[connection.required] = &connection;
      if (connection.state == ConnectionState::kActive) {
        clients_[connection.provided].push_back(connection.required);
      }
    }
  }
  for (auto& [provided, clients] : clients_) std::sort(clients.begin(), clients.end());
}

const ConnectionDescription* ConnectionIndex::Of(const InterfaceName& required) const {
  const auto it = by_required_.find(required);
  return it == by_required_.end() ? nullptr : it->second;
}

int ConnectionIndex::Clients(const InterfaceName& provided) const {
  return static_cast<int>(ClientsOf(provided).size());
}

const std::vector<InterfaceName>& ConnectionIndex::ClientsOf(const InterfaceName& provided) const {
  static const std::vector<InterfaceName> kNone;
  const auto it = clients_.find(provided);
  return it == clients_.end() ? kNone : it->second;
}

}  // namespace tendon::gui
