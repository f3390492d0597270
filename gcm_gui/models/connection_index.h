#pragma once

#include <tendon/gcm/catalog.h>

#include <map>
#include <vector>

namespace tendon::gui {

/// The connections of a catalogue by their ends. Made in one pass for one look at the catalogue;
/// points into it, so it must not outlive the next change.
class ConnectionIndex {
 public:
  explicit ConnectionIndex(const Catalog& catalogue);

  /// Null where it has none.
  [[nodiscard]] const ConnectionDescription* Of(const InterfaceName& required) const;
  /// How many required interfaces use it now.
  [[nodiscard]] int Clients(const InterfaceName& provided) const;
  /// Those required interfaces, sorted.
  [[nodiscard]] const std::vector<InterfaceName>& ClientsOf(const InterfaceName& provided) const;

 private:
  std::map<InterfaceName, const ConnectionDescription*> by_required_;
  std::map<InterfaceName, std::vector<InterfaceName>> clients_;
};

}  // namespace tendon::gui
