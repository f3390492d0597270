#pragma once

#include "targets.h"

namespace fuzz {

/// Decodes a body. The first byte chooses the type; the rest is the body.
void DecodeTyped(Bytes bytes);

/// Reads a value as JSON. The first byte chooses the type; the rest is the JSON.
void ReadJson(Bytes bytes);

}  // namespace fuzz
