#pragma once

#include <tendon/interface/description.h>
#include <tendon/payload/fingerprint.h>

#include <string>
#include <vector>

namespace tendon {

/// A read command that may say what a command is to begin with.
struct MatchingRead {
  std::string name;
  Fingerprint type;      ///< of its answer
  bool is_whole = true;  ///< it answers what the command takes; else a structure, some fields of
                         ///< which may be the same

  bool operator==(const MatchingRead&) const = default;
};

/// The read commands of the interface that may say what `command` would set, the likeliest first:
/// one that answers the type that it takes, of several that which is named likewise, GetGains for
/// SetGains; then, where it takes a structure, those that answer another one.
[[nodiscard]] std::vector<MatchingRead> MatchingReads(const ProvidedDescription& of,
                                                      const MemberDescription& command);

}  // namespace tendon
