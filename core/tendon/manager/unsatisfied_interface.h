#pragma once

#include <tendon/base/result.h>
#include <tendon/manager/component_description.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// A required interface that a component needs and that has no active connection.
struct UnsatisfiedInterface {
  std::string interface;
  std::string reason;           ///< "not connected", "pending: process 'robot' is not available"
  bool has_connection = false;  ///< there is a connection, but it is not active

  bool operator==(const UnsatisfiedInterface&) const = default;
};

/// True if a component needs the interface: neither the interface nor all of its functions and
/// event handlers are optional.
[[nodiscard]] bool IsNeeded(const RequiredDescription& required);

/// Finds the connection of the required interface of this name; null if there is none.
using FindConnection =
    std::function<const ConnectionDescription*(const std::string& required_interface)>;

/// The unsatisfied interfaces of a component, in the order of its required interfaces.
[[nodiscard]] std::vector<UnsatisfiedInterface> UnmetNeedsOf(const ComponentDescription& component,
                                                             const FindConnection& find);

/// The same, with all connections of its process. The cost is proportional to connections times
/// interfaces.
[[nodiscard]] std::vector<UnsatisfiedInterface> UnmetNeedsOf(
    const ComponentDescription& component, const std::vector<ConnectionDescription>& connections);

/// "Robot, Camera".
[[nodiscard]] std::string NamesOf(const std::vector<UnsatisfiedInterface>& needs);

/// With the reasons: "Robot: not connected; Camera: pending: process 'eye' is not available".
[[nodiscard]] std::string ReasonsOf(const std::vector<UnsatisfiedInterface>& needs);

/// Fails if a component with unsatisfied interfaces should start; the error is for people.
[[nodiscard]] Result<void> CheckNeeds(const std::string& component,
                                      const std::vector<UnsatisfiedInterface>& needs);

}  // namespace tendon
