#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/mcap_reader.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon::recording {

struct Hdf5Report {
  std::vector<std::string> groups;  ///< "/robot/arm/state"
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;        ///< rows that are missing between them
  std::uint64_t incomplete = 0;  ///< rows that are left out, since a part is missing or malformed
  std::uint64_t skipped = 0;     ///< messages of channels without a Tendon schema
};

/// Writes the messages that match as HDF5, a group for each state table, event and other topic:
///
///     /robot/arm/state/time_ns           int64, since 1970
///     /robot/arm/state/source_time_ns    int64, on the steady clock of the source
///     /robot/arm/state/tick              uint64; of an event `sequence`
///     /robot/arm/state/starts            int64, the rows with which the source began anew
///     /robot/arm/state/gaps/...          row, missing, begin_ns, end_ns: where rows are missing
///     /robot/arm/state/Joints/position   rows x 7, float64; attribute unit = "rad"
///     /robot/arm/Control/Limit/value/... the value of an event, with its fields
///
/// Numbers keep their types. A bool is uint8 and an enum int32, both with the attributes `names`
/// and `values`; a duration is int64 in ns; text is UTF-8 of variable length. A column with
/// sequences has a dataset `NAME.json` with its whole value as JSON.
///
/// Writes `file`.part, which gets its name when it is complete, so that a full disk leaves no half
/// file. kExists if `file` is there already, kInvalid if no channel has a Tendon schema, kNotFound
/// if Tendon was built without HDF5.
///
/// HDF5 and the 30 libraries that it needs are loaded at the first call, not with the program. Call
/// it in one thread at a time.
Result<Hdf5Report> ExportHdf5(mcap::Reader& reader, const mcap::Query& query,
                              const std::filesystem::path& file);

}  // namespace tendon::recording
