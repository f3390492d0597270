#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon::client {

/// The text in a JSON value at a path's field, ".position[0]", exactly as written; the whole text
/// if `field` is empty. If the value has no such field, fails with kNotFound, and the error names
/// the part of the path.
Result<std::string> JsonField(const std::string& json, const std::string& field);

}  // namespace tendon::client
