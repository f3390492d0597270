#pragma once

#include <tendon/recording/hdf5_export.h>

namespace tendon::recording {

/// What the module tendon_hdf5 exports, the only part of Tendon that uses HDF5: that library takes
/// 30 others with it, which no other program should have to load.
using Hdf5Module = void(mcap::Reader& reader, const mcap::Query& query,
                        const std::filesystem::path& file, Result<Hdf5Report>& report);
inline constexpr const char* kHdf5Symbol = "TendonExportHdf5";

}  // namespace tendon::recording
