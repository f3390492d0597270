#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <vector>

namespace tendon {

/// A required interface and the provided interfaces that may belong to it.
struct Match {
  InterfaceName required;
  std::vector<InterfaceName> provided;  ///< all equally good candidates; one if the choice is clear
};

/// Globs of process/component/interface that limit the match.
struct MatchPatterns {
  std::string required;
  std::string provided;
};

/// For each unconnected required interface that matches the pattern: the provided interfaces that
/// fit it, or only the one with the same name if that one fits; never one of its own component.
/// Sorted by path. Linear in matching required times provided interfaces. Errors: kNotFound if a
/// pattern matches nothing.
Result<std::vector<Match>> MatchInterfaces(const Catalogue& catalogue,
                                           const MatchPatterns& patterns);

}  // namespace tendon
