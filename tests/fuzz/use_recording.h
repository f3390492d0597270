#pragma once

#include "targets.h"

namespace fuzz {

/// Replays the bytes as a recording: reads its items, and plays them in processes.
void ReplayRecording(Bytes bytes);
/// Exports the bytes as a recording into an HDF5 file.
void ExportAsHdf5(Bytes bytes);

}  // namespace fuzz
