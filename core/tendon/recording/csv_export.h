#pragma once

#include <tendon/base/os/part_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/channel_groups.h>
#include <tendon/recording/mcap/reader.h>

#include <filesystem>
#include <vector>

namespace tendon::recording {

/// The result of ExportCsv().
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
/// whole value as JSON. A member with kMaxNumericFields numbers or more has such a column, too, and
/// only its first numbers have their own columns. If rows are missing, a row without values
/// contains their number in `lost`. A malformed value has empty cells, and its row counts as
/// incomplete.
///
/// Creates `folder`. The files get their final names when all are complete. After an error, or if
/// `stop` returns true, no file is left. Fails with kExists, and changes no file, if one of the
/// files already exists, or if another export into the same folder is running on this computer.
/// Fails with kInvalid if no channel of the recording describes its values, or if there are more
/// than kMaxColumns columns. Fails with kFailed if the disk is full or fails, or if a program on
/// another computer writes to the same files.
///
/// Thread safety: as for the reader. Cost: reads each chunk once; memory for one row of each file,
/// and for 64 KiB of it or 64 MiB of all files. Keeps at most 64 of the files open, and opens
/// the others again when their text is written.
Result<CsvReport> ExportCsv(mcap::Reader& reader, const mcap::Query& query,
                            const std::filesystem::path& folder, const os::StopRequest& stop = {});

}  // namespace tendon::recording
