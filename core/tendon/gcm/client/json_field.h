#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon::client {

/// Returns a part of a JSON text, exactly as it is written there. `field` selects the part, for
/// example ".position[0]"; if it is empty, returns the whole text. Fails with kNotFound if there is
/// no such part; the error names the part of `field` that does not exist.
Result<std::string> JsonField(const std::string& json, const std::string& field);

}  // namespace tendon::client
