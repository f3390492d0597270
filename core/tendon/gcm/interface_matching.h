#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <vector>

namespace tendon {

/// A required interface and the provided interfaces that fit it.
struct Match {
  InterfaceName required;
  /// All equally good candidates; only one if the choice is clear.
  std::vector<InterfaceName> provided;
};

/// Globs over process/component/interface: only interfaces whose path matches are considered.
struct MatchPatterns {
  std::string required;
  std::string provided;
};

/// For each required interface without a connection, finds the provided interfaces of other
/// components that fit it. Considers only interfaces that match the patterns. If some of the
/// provided interfaces that fit have the same name as the required interface, returns only these.
/// The result is sorted by path. The cost is proportional to the number of required interfaces
/// times the number of provided interfaces. Fails with kNotFound if one of the patterns matches no
/// interface.
Result<std::vector<Match>> MatchInterfaces(const Catalogue& catalogue,
                                           const MatchPatterns& patterns);

}  // namespace tendon
