#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace tendon {

/// A read command whose result can be the initial argument of another command.
struct MatchingRead {
  std::string name;
  Fingerprint type;  ///< type of its result
  /// True if the result is a whole argument. False if the result is a structure that may have some
  /// fields in common with the argument.
  bool is_whole = true;

  bool operator==(const MatchingRead&) const = default;
};

/// Returns the read commands of an interface that may return the value that `command` sets. The
/// most likely one comes first: a command that returns the type of the argument. If there are
/// several, the command with the same subject is chosen, such as GetGains for SetGains. If the
/// argument is a structure, all commands that return other structures follow.
[[nodiscard]] std::vector<MatchingRead> MatchingReads(const ProvidedDescription& of,
                                                      const MemberDescription& command);

/// Returns the names of the fields that both structures have with the same type and unit. Returns
/// nothing if one of the two is not a structure. Also returns nothing if a value of `offered` may
/// be large, because a whole image should not be read to get its width.
[[nodiscard]] std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered);

/// Returns the JSON object `value`, in which `fields` have the values from the JSON object
/// `source`. Returns `value` unchanged if one of the two is not an object.
[[nodiscard]] std::string WithFieldsOf(const std::string& value, const std::string& source,
                                       const std::vector<std::string>& fields);

}  // namespace tendon
