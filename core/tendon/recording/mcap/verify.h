#pragma once

#include <tendon/recording/mcap/chunk.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/records.h>

namespace tendon::mcap {

/// The result of Verify().
struct Verification {
  Statistics found;   ///< counts of the data in the file, independent of the summary
  Problems problems;  ///< everything that is damaged or missing, including problems found when the
                      ///< file was opened
};

/// Reads the whole file and checks all redundant data of the format: the checksums of chunks,
/// attachments, summary and data section, the message indexes, the times and the counts.
///
/// Thread safety: as for the reader. Cost: reads the file twice and decompresses each chunk once.
/// Does not throw.
Verification Verify(Reader& reader);

}  // namespace tendon::mcap
