#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>

#include <string>
#include <vector>

namespace tendon {

/// A required interface, and which of many provided ones is meant for it.
struct Match {
  InterfaceName required;
  std::vector<InterfaceName> provided;  ///< all that are equally good: one where it is clear
};

/// What may be matched with what: globs of process/component/interface.
struct MatchPatterns {
  std::string required;
  std::string provided;
};

/// For each required interface that is named and free, what fits it: of several, the one that has
/// its name; never one of its own component. In order of their paths; one that is connected is left
/// out. Linear in the required interfaces that are named times the provided ones. Errors: kNotFound
/// where a pattern names nothing that is there.
Result<std::vector<Match>> MatchInterfaces(const Catalog& catalog, const MatchPatterns& patterns);

}  // namespace tendon
