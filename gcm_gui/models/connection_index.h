#pragma once

#include <tendon/gcm/catalogue.h>

#include <map>
#include <vector>

namespace tendon::gui {

/// Finds the connections of a catalogue by their interfaces. Built in one pass. It contains
/// pointers into the catalogue, so it must not outlive the next change.
class ConnectionIndex {
 public:
  explicit ConnectionIndex(const Catalogue& catalogue);

  /// Returns the connection of this required interface; null if there is none.
  [[nodiscard]] const ConnectionDescription* Of(const InterfaceName& required) const;
  /// Returns the number of required interfaces that are connected to `provided`.
  [[nodiscard]] int Clients(const InterfaceName& provided) const;
  /// Returns the required interfaces that are connected to `provided`, sorted.
  [[nodiscard]] const std::vector<InterfaceName>& ClientsOf(const InterfaceName& provided) const;

 private:
  std::map<InterfaceName, const ConnectionDescription*> by_required_;
  std::map<InterfaceName, std::vector<InterfaceName>> clients_;
};

}  // namespace tendon::gui
