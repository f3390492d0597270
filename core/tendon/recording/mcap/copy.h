#pragma once

#include <tendon/base/os/part_file.h>
#include <tendon/base/result.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/writer.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon::mcap {

/// What Copy() or Recover() has copied.
struct CopyReport {
  std::uint64_t messages = 0;  ///< that are in the new file
  std::uint64_t attachments = 0;
  std::uint64_t metadata = 0;
  std::vector<Problem> problems;    ///< of the file that was read: the first 100
  std::uint64_t problem_count = 0;  ///< all of them
};

/// Writes the messages that match, all schemas and channels, attachments and metadata into
/// `writer`, which is not closed. Channels and schemas get new ids. Leaves out damaged parts and
/// names them in the report. Fails if the writer does, and when `stop` returns true. Throws
/// nothing.
///
/// Thread safety: that of the reader and the writer. Cost: reads all chunks, and compresses them
/// again.
Result<CopyReport> Copy(Reader& reader, const Query& query, Writer& writer,
                        const os::StopRequest& stop = {});

/// Copies into the new file `to`, which is complete or not there: see os::PartFile. kExists if it
/// is there already.
Result<CopyReport> Copy(Reader& reader, const Query& query, const std::filesystem::path& to,
                        WriterOptions options, const os::StopRequest& stop = {});

/// Writes everything that can be read of a damaged file, or of one without its end, into a new file
/// with an index. The messages keep the order of the old file, and the new file has its profile.
/// Otherwise like Copy(). Never changes the old file. Cost: that of Copy(), and one more pass over
/// the old file.
Result<CopyReport> Recover(const std::filesystem::path& from, const std::filesystem::path& to,
                           const WriterOptions& options = {}, const os::StopRequest& stop = {});

}  // namespace tendon::mcap
