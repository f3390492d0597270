#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace console {

/// Converts words of a command line to the argument of a command, and returns it as JSON. The
/// argument is one word of JSON, or one word for each field of a structure, in the order of the
/// fields or as name=value. Texts and enumerators need no quotes. Every error is kInvalid and
/// begins with `command`.
tendon::Result<std::string> ArgumentOf(const tendon::Schema& schema, const std::string& command,
                                       const std::vector<std::string>& words);

/// Returns the words that may follow `words`: "mode=" for each field that was not given yet, and
/// the values of a field with named values, both with and without the name of the field.
std::vector<std::string> NextWords(const tendon::Schema& schema,
                                   const std::vector<std::string>& words);

/// Returns the names of all values of the type; empty if the values have no names.
std::vector<std::string> ValuesOf(const tendon::Schema& schema);

}  // namespace console
