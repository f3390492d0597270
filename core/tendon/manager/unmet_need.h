#pragma once

#include <tendon/base/result.h>
#include <tendon/manager/description.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// A required interface that a component needs, and that nothing serves.
struct UnmetNeed {
  std::string interface;
  std::string reason;           ///< "not connected", "pending: process 'robot' is not there"
  bool has_connection = false;  ///< there is one, which does not stand

  bool operator==(const UnmetNeed&) const = default;
};

/// Whether a component needs the interface: it is not optional, nor are all of its functions and
/// event handlers.
[[nodiscard]] bool IsNeeded(const RequiredDescription& required);

/// The connection that the required interface of this name has, or null.
using FindConnection =
    std::function<const ConnectionDescription*(const std::string& required_interface)>;

/// Of a component, in the order of its required interfaces.
[[nodiscard]] std::vector<UnmetNeed> UnmetNeedsOf(const ComponentDescription& component,
                                                  const FindConnection& find);

/// The same where its process has these connections: linear in them times its interfaces.
[[nodiscard]] std::vector<UnmetNeed> UnmetNeedsOf(
    const ComponentDescription& component, const std::vector<ConnectionDescription>& connections);

/// "Robot, Camera".
[[nodiscard]] std::string NamesOf(const std::vector<UnmetNeed>& needs);

/// With the reasons: "Robot: not connected; Camera: pending: process 'eye' is not there".
[[nodiscard]] std::string ReasonsOf(const std::vector<UnmetNeed>& needs);

/// Refuses to start a component that lacks what it needs, for who has asked for that.
[[nodiscard]] Result<void> CheckNeeds(const std::string& component,
                                      const std::vector<UnmetNeed>& needs);

}  // namespace tendon
