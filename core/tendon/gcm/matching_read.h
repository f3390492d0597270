#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/payload/fingerprint.h>

#include <string>
#include <vector>

namespace tendon {

/// A read command whose value may be the initial argument of another command.
struct MatchingRead {
  std::string name;
  Fingerprint type;      ///< type of its result
  bool is_whole = true;  ///< returns the whole argument; otherwise a structure with some common
                         ///< fields

  bool operator==(const MatchingRead&) const = default;
};

/// The read commands of the interface that may return the value that `command` sets, the most
/// likely first: one that returns the argument's type (of several, the one with the same subject,
/// as GetGains for SetGains); then, if the argument is a structure, those that return other
/// structures.
[[nodiscard]] std::vector<MatchingRead> MatchingReads(const ProvidedDescription& of,
                                                      const MemberDescription& command);

}  // namespace tendon
