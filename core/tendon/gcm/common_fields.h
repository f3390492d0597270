#pragma once

#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace tendon {

/// The names of the fields of structure `wanted` that `offered` also has, with the same type and
/// unit. Empty if either is not a structure, or if a value of `offered` may be large: an image
/// should not be read to get its width.
[[nodiscard]] std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered);

/// The JSON object `value` with these fields copied from `source`; `value` unchanged if either is
/// not an object.
[[nodiscard]] std::string WithFieldsOf(const std::string& value, const std::string& source,
                                       const std::vector<std::string>& fields);

}  // namespace tendon
