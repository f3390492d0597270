#pragma once

#include <tendon/base/result.h>
#include <tendon/manager/component_description.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// A required interface that a component needs, but that has no active connection.
struct UnsatisfiedInterface {
  std::string interface;
  std::string reason;           ///< "not connected", "pending: process 'robot' is not available"
  bool has_connection = false;  ///< true if there is a connection, but it is not active

  bool operator==(const UnsatisfiedInterface&) const = default;
};

/// Returns true if a component needs the interface: the interface is not optional, and at least one
/// of its functions or event handlers is not optional.
[[nodiscard]] bool IsNeeded(const RequiredDescription& required);

/// Returns the connection of the required interface with this name; null if it has none.
using FindConnection =
    std::function<const ConnectionDescription*(const std::string& required_interface)>;

/// Returns the unsatisfied interfaces of a component, in the order of its required interfaces.
[[nodiscard]] std::vector<UnsatisfiedInterface> UnmetNeedsOf(const ComponentDescription& component,
                                                             const FindConnection& find);

/// Like the function above. `connections` are all connections of the component's process. The cost
/// is proportional to the number of connections times the number of interfaces.
[[nodiscard]] std::vector<UnsatisfiedInterface> UnmetNeedsOf(
    const ComponentDescription& component, const std::vector<ConnectionDescription>& connections);

/// Returns the names: "Robot, Camera".
[[nodiscard]] std::string NamesOf(const std::vector<UnsatisfiedInterface>& needs);

/// Returns the names with the reasons: "Robot: not connected; Camera: pending: process 'eye' is not
/// available".
[[nodiscard]] std::string ReasonsOf(const std::vector<UnsatisfiedInterface>& needs);

/// Fails if `needs` is not empty. The error says why the component is not started.
[[nodiscard]] Result<void> CheckNeeds(const std::string& component,
                                      const std::vector<UnsatisfiedInterface>& needs);

}  // namespace tendon
