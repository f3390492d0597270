#pragma once

#include <tendon/recording/mcap/chunk.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/records.h>

namespace tendon::mcap {

/// The result of Verify().
struct Verification {
  Statistics found;   ///< what is in the file, whatever its summary states
  Problems problems;  ///< everything that is damaged or missing, also what opening the file showed

  [[nodiscard]] bool is_intact() const { return problems.count() == 0; }
};

/// Reads the whole file and compares everything that the format has twice: the checksums of chunks,
/// attachments, summary and data section, the message indexes, the times and the counts.
///
/// Thread safety: that of the reader. Cost: reads the file twice and decompresses each chunk once.
/// Throws nothing.
Verification Verify(Reader& reader);

}  // namespace tendon::mcap
