#pragma once

#include <tendon/payload/schema.h>

#include <string>
#include <vector>

namespace tendon {

/// The fields of the structure `wanted` that `offered` has too, by name: of the same type and in
/// the same unit. None where one of both is no structure, nor where a value of `offered` may be
/// large: nobody asks for an image to have its width.
[[nodiscard]] std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered);

/// The JSON object `value` with these fields as `source` has them; `value` where one of both is
/// none.
[[nodiscard]] std::string WithFieldsOf(const std::string& value, const std::string& source,
                                       const std::vector<std::string>& fields);

}  // namespace tendon
