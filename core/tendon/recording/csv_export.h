#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/mcap_reader.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tendon::recording {

struct CsvReport {
  std::vector<std::filesystem::path> files;
  std::uint64_t rows = 0;
  std::uint64_t lost = 0;     ///< rows that are missing between them
  std::uint64_t skipped = 0;  ///< messages of channels without a Tendon schema
};

/// Writes the messages that match as CSV, one file for each state table, event and other topic:
/// `robot.arm.state.csv`. Its columns are
///
///     time_ns,source_time_ns,sequence,lost,Joints.position[0],...
///
/// the time since 1970, the time on the steady clock of the source, the low 32 bits of the tick,
/// and one column for each number. A member with texts or sequences also has a column with its
/// whole value as JSON. Where rows are missing, a row without values says how many, in `lost`.
///
/// Creates `folder`. kExists if a file is there already; then no file is changed. kInvalid if no
/// channel of the recording has a Tendon schema.
Result<CsvReport> ExportCsv(mcap::Reader& reader, const mcap::Query& query,
                            const std::filesystem::path& folder);

}  // namespace tendon::recording
