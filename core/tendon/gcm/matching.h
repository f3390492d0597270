#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <vector>

namespace tendon {

/// A required interface and the provided ones that may be meant for it.
struct Match {
  InterfaceName required;
  std::vector<InterfaceName> provided;  ///< all that are equally good; one if it is clear
};

/// Globs of process/component/interface that limit the match.
struct MatchPatterns {
  std::string required;
  std::string provided;
};

/// For each free required interface that matches the pattern, the provided interfaces that fit it,
/// or only the one with its name if that fits; never one of its own component. In the order of
/// their paths. Linear in matching required times provided interfaces. Errors: kNotFound if a
/// pattern matches nothing.
Result<std::vector<Match>> MatchInterfaces(const Catalogue& catalogue,
                                           const MatchPatterns& patterns);

}  // namespace tendon
