#pragma once

#include <tendon/recording/mcap/reader.h>

#include <filesystem>
#include <memory>

#include "targets.h"

namespace fuzz {

/// An MCAP file with small limits, so that a small file reaches them. Null if it is none.
std::unique_ptr<tendon::mcap::Reader> OpenRecording(Bytes bytes);

/// A path of this process, where an export writes in memory if the system can.
std::filesystem::path ExportPath();

/// An MCAP file, exported as CSV.
void ExportAsCsv(Bytes bytes);

}  // namespace fuzz
