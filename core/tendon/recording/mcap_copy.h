#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/mcap_reader.h>
#include <tendon/recording/mcap_writer.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon::mcap {

struct CopyReport {
  std::uint64_t messages = 0;  ///< that are in the new file
  std::uint64_t attachments = 0;
  std::uint64_t metadata = 0;
  std::vector<Problem> problems;    ///< of the file that was read: the first 100
  std::uint64_t problem_count = 0;  ///< all of them
};

/// Writes the messages that match, all schemas and channels, attachments and metadata into
/// `writer`, which is not closed. Channels and schemas get new ids. What cannot be read is left out
/// and told in the report. Fails if the writer does. Throws nothing.
///
/// Thread safety: as the reader and the writer. Cost: reads all chunks, and compresses them anew.
Result<CopyReport> Copy(Reader& reader, const Query& query, Writer& writer);

/// Writes all that can be read of a damaged or cut-off file into a new one that has an index,
/// messages in the order of the file, with the profile of the old one. kExists if the new file is
/// there already; the old one is never changed.
Result<CopyReport> Recover(const std::filesystem::path& from, const std::filesystem::path& to,
                           WriterOptions options = {});

}  // namespace tendon::mcap
