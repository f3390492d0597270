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
  std::vector<InterfaceName> provided;  ///< all equally good candidates; one if the choice is clear
};

/// Globs of process/component/interface that limit the match.
struct MatchPatterns {
  std::string required;
  std::string provided;
};

/// Finds the provided interfaces that fit each unconnected required interface. Both must match
/// their pattern, and belong to different components. If some of the provided interfaces have the
/// same name as the required one, returns only these. Sorted by path. The cost is proportional to
/// the number of required times the number of provided interfaces. kNotFound if a pattern matches
/// nothing.
Result<std::vector<Match>> MatchInterfaces(const Catalogue& catalogue,
                                           const MatchPatterns& patterns);

}  // namespace tendon
