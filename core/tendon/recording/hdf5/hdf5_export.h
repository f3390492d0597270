#pragma once

#include <tendon/base/os/part_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/mcap/reader.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tendon::recording {

/// The result of ExportHdf5().
struct Hdf5Report : ExportReport {
  std::vector<std::string> groups;  ///< "/robot/arm/state"
};

/// Writes the messages that match as HDF5, with one group for each state table, event and other
/// topic:
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
/// A row with a missing or malformed part is left out, and counts as incomplete.
///
/// Writes `file`.part, which gets its final name when it is complete; after an error, or if `stop`
/// returns true, there is no file. Fails with kExists if `file` exists already, with kInvalid if no
/// channel describes its values or there are more than kMaxColumns datasets, and with kNotFound if
/// Tendon was built without HDF5.
///
/// HDF5 and the 30 libraries that it needs are loaded at the first call, not with the program.
///
/// Thread safety: one call at a time in the whole process. Cost: reads each chunk once; memory for
/// about 64 KiB of each dataset.
Result<Hdf5Report> ExportHdf5(mcap::Reader& reader, const mcap::Query& query,
                              const std::filesystem::path& file, const os::StopRequest& stop = {});

}  // namespace tendon::recording
