#pragma once

#include "targets.h"

namespace fuzz {

/// An MCAP file: opened, read in both orders, verified, and recovered.
void ReadRecording(Bytes bytes);

}  // namespace fuzz
