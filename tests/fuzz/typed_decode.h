#pragma once

#include "targets.h"

namespace fuzz {

/// The first byte chooses a type; the rest is a body.
void DecodeTyped(Bytes bytes);

/// The first byte chooses a type; the rest is its JSON.
void ReadJson(Bytes bytes);

}  // namespace fuzz
