#pragma once

#include "targets.h"

namespace fuzz {

/// The targets that need all layers, so they are not in the program for libFuzzer: a recording that
/// is replayed, and one that is exported as HDF5.
[[nodiscard]] std::span<const Target> RecordingTargets();

}  // namespace fuzz
