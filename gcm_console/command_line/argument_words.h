#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace console {

/// Reads the argument of a command from words: one word of JSON, or one word per field of a
/// structure, in order or as name=value. A text or an enumerator needs no quotes. Returns JSON.
/// Every error is kInvalid and begins with `command`.
tendon::Result<std::string> ArgumentOf(const tendon::Schema& schema, const std::string& command,
                                       const std::vector<std::string>& words);

/// The words that may follow `words`: "mode=" for each field that is not given yet, and each value
/// of a field with named values, with and without the field's name.
std::vector<std::string> NextWords(const tendon::Schema& schema,
                                   const std::vector<std::string>& words);

/// The names of all values of the type; empty if its values have no names.
std::vector<std::string> ValuesOf(const tendon::Schema& schema);

}  // namespace console
