#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace console {

/// The argument of a command as words: one of JSON, or one for each field of a structure, in their
/// order or as name=value. A text or the name of an enumerator needs no quotes. Returns JSON; the
/// errors, kInvalid, begin with `command`.
tendon::Result<std::string> ArgumentOf(const tendon::Schema& schema, const std::string& command,
                                       const std::vector<std::string>& words);

/// What can be said behind `words`: "mode=" of each field that is not given yet, and each value of
/// those that have names for them, with and without the field's name.
std::vector<std::string> WordsBehind(const tendon::Schema& schema,
                                     const std::vector<std::string>& words);

/// The names of all values of the type, where they have any.
std::vector<std::string> ValuesOf(const tendon::Schema& schema);

}  // namespace console
