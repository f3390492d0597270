#pragma once

#include "targets.h"

namespace fuzz {

/// Opens the bytes as an MCAP file, reads it in both orders, verifies it, and recovers it.
void ReadRecording(Bytes bytes);

}  // namespace fuzz
