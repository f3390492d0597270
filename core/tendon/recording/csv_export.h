#pragma once

#include <tendon/base/os/part_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/mcap/reader.h>

#include <filesystem>
#include <vector>

namespace tendon::recording {

/// What ExportCsv() has written.
struct CsvReport : ExportReport {
  std::vector<std::filesystem::path> files;
};

/// Writes the messages that match as CSV, one file for each state table, event, command and other
/// topic:
/// `robot.arm.state.csv`. Its columns are
///
///     time_ns,source_time_ns,sequence,lost,Joints.position[0],...
///
/// the time since 1970, the time on the steady clock of the source, the low 32 bits of the tick,
/// and one column for each number. A member with texts or sequences also has a column with its
/// whole value as JSON; so has a member with kMaxNumericFields numbers or more, of which only the
/// first ones have columns. Where rows are missing, a row without values says how many, in `lost`.
/// A value that is malformed has empty cells, and its row counts as incomplete.
///
/// Creates `folder`. The files get their names when all are complete; on an error, and when `stop`
/// returns true, no file is there. kExists if a file is there already; then no file is changed.
/// kInvalid if no channel of the recording describes its values, or there are more than
/// kMostColumns columns; kFailed if the disk is full or
/// fails.
///
/// Thread safety: that of the reader. Cost: reads each chunk once; memory for one row and 64 KiB of
/// each file.
Result<CsvReport> ExportCsv(mcap::Reader& reader, const mcap::Query& query,
                            const std::filesystem::path& folder, const os::StopRequest& stop = {});

}  // namespace tendon::recording
