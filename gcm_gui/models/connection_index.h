#pragma once

#include <tendon/gcm/catalogue.h>

#include <map>
#include <vector>

namespace tendon::gui {

/// The connections of a catalogue, indexed by their ends. Built in one pass. It points into the
/// catalogue, so it must not outlive the next change.
class ConnectionIndex {
 public:
  explicit ConnectionIndex(const Catalogue& catalogue);

  /// Null if there is none.
  [[nodiscard]] const ConnectionDescription* Of(const InterfaceName& required) const;
  /// The number of required interfaces connected to `provided`.
  [[nodiscard]] int Clients(const InterfaceName& provided) const;
  /// These required interfaces, sorted.
  [[nodiscard]] const std::vector<InterfaceName>& ClientsOf(const InterfaceName& provided) const;

 private:
  std::map<InterfaceName, const ConnectionDescription*> by_required_;
  std::map<InterfaceName, std::vector<InterfaceName>> clients_;
};

}  // namespace tendon::gui
