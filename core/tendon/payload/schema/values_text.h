#pragma once

#include <tendon/payload/schema.h>

#include <string>

namespace tendon {

/// Values of the field, for people: "0 to 2.5", "off, on"; empty if the type says enough.
[[nodiscard]] std::string ValuesText(const Schema::Field& field);

}  // namespace tendon
