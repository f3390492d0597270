#pragma once

#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace tendon {

/// The names of the fields of structure `wanted` that `offered` has too, with the same type and
/// unit. None if one of both is no structure, or if a value of `offered` may be large: nobody reads
/// an image to get its width.
[[nodiscard]] std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered);

/// The JSON object `value` with these fields copied from `source`; unchanged `value` if either is
/// no object.
[[nodiscard]] std::string WithFieldsOf(const std::string& value, const std::string& source,
                                       const std::vector<std::string>& fields);

}  // namespace tendon
