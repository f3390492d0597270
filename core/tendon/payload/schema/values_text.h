#pragma once

#include <tendon/payload/schema.h>

#include <string>

namespace tendon {

/// What the field can hold, for people: "0 to 2.5", "off, on"; empty where its type says it all.
[[nodiscard]] std::string ValuesText(const Schema::Field& field);

}  // namespace tendon
