#pragma once

#include <tendon/payload/schema.h>

#include <string>

namespace tendon {

/// Returns the possible values of a field, for people: "0 to 2.5" for a range, "off, on" for an
/// enum. Empty for any other field.
[[nodiscard]] std::string ValuesText(const Schema::Field& field);

}  // namespace tendon
