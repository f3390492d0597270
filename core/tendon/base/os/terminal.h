#pragma once

namespace tendon::os {

enum class Stream { kInput, kOutput, kError };

/// Columns of the terminal of this stream, 80 if unknown; 0 if the stream is a pipe or a file.
int TerminalColumns(Stream stream) noexcept;

/// Lines of the terminal at the standard output, 24 if unknown.
[[nodiscard]] int TerminalRows() noexcept;

/// Opens each of the three standard streams that is closed, so that no socket gets its descriptor
/// number. Reads and writes of such a stream fail. Call it first in main().
void GuardStreams() noexcept;

/// Makes a write to a pipe without a reader fail, instead of killing the process.
void IgnoreBrokenPipes() noexcept;

}  // namespace tendon::os
