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

/// The result of Copy() or Recover().
struct CopyReport {
  std::uint64_t messages = 0;  ///< number of messages in the new file
  std::uint64_t attachments = 0;
  std::uint64_t metadata = 0;
  std::vector<Problem> problems;    ///< the first 100 problems of the file that was read
  std::uint64_t problem_count = 0;  ///< number of all problems
};

/// Writes the messages that match, and all schemas, channels, attachments and metadata, into
/// `writer`, which is not closed. Channels and schemas get new ids. Leaves out damaged parts and
/// names them in the report. Fails if the writer fails or `stop` returns true. Does not throw.
///
/// Thread safety: as for the reader and the writer. Cost: reads all chunks, and compresses them
/// again.
Result<CopyReport> Copy(Reader& reader, const Query& query, Writer& writer,
                        const os::StopRequest& stop = {});

/// Copies into the new file `to`. After an error, this file does not exist (see os::PartFile).
/// Fails with kExists if it exists before.
Result<CopyReport> Copy(Reader& reader, const Query& query, const std::filesystem::path& to,
                        WriterOptions options, const os::StopRequest& stop = {});

/// Copies all readable parts of a damaged or cut file into a new file with an index. The new file
/// has the profile of the old file and its order of messages. Otherwise like Copy(). Never changes
/// the old file. Cost: as for Copy(), and one more pass over the old file.
Result<CopyReport> Recover(const std::filesystem::path& from, const std::filesystem::path& to,
                           const WriterOptions& options = {}, const os::StopRequest& stop = {});

}  // namespace tendon::mcap
