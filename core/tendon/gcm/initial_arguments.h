#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>

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
/// likely one first. Commands that return the type of the argument come first; among them, a
/// command with the same subject, such as GetGains for SetGains. If the argument is a structure,
/// commands that return other structures follow.
[[nodiscard]] std::vector<MatchingRead> MatchingReads(const ProvidedDescription& of,
                                                      const MemberDescription& command);

/// The names of the fields of structure `wanted` that `offered` also has, with the same type and
/// unit. Empty if either is not a structure, or if a value of `offered` may be large: an image
/// should not be read to get its width.
[[nodiscard]] std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered);

/// Copies these fields from the JSON object `source` to the JSON object `value`, and returns the
/// result. Returns `value` unchanged if either is not an object.
[[nodiscard]] std::string WithFieldsOf(const std::string& value, const std::string& source,
                                       const std::vector<std::string>& fields);

}  // namespace tendon
