#pragma once

#include <tendon/base/result.h>

#include <string>

namespace tendon::client {

/// Returns a part of a JSON text, exactly as the text has it. `field` selects the part, for example
/// ".position[0]"; an empty `field` selects the whole text. Fails with kNotFound if the part does
/// not exist; the error says which piece of `field` is wrong.
Result<std::string> JsonField(const std::string& json, const std::string& field);

}  // namespace tendon::client
