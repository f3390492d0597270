#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon::client {

/// The part of a JSON text at a path's field, ".position[0]", as it is written there; all of it
/// where the field is empty. kNotFound says where the path leaves the value.
Result<std::string> JsonField(const std::string& json, const std::string& field);

}  // namespace tendon::client
