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
  /// All equally good candidates. If the choice is clear, there is only one.
  std::vector<InterfaceName> provided;
};

/// Globs for process/component/interface. Only interfaces whose path matches are considered.
struct MatchPatterns {
  std::string required;
  std::string provided;
};

/// Finds, for each required interface without a connection, the provided interfaces of other
/// components that fit it. Considers only interfaces that match the patterns. If some fitting
/// interfaces have the same name as the required interface, returns only these. The result is
/// sorted by path. Fails with kNotFound if a pattern matches no interface. The cost is the number
/// of required interfaces times the number of provided interfaces.
Result<std::vector<Match>> MatchInterfaces(const Catalogue& catalogue,
                                           const MatchPatterns& patterns);

}  // namespace tendon
