#pragma once

namespace tendon::os {

enum class Stream { kInput, kOutput, kError };

/// Columns of the terminal of this stream, 80 if it does not tell; 0 if the stream is a pipe or a
/// file.
int TerminalColumns(Stream stream) noexcept;

/// Lines of the terminal at the standard output, 24 if it does not tell.
[[nodiscard]] int TerminalRows() noexcept;

/// Makes sure that the three streams exist, so that no socket gets their numbers; writing to one
/// that was closed fails. Call it first in main().
void GuardStreams() noexcept;

/// Makes a write to a pipe without a reader fail, instead of killing the process.
void IgnoreBrokenPipes() noexcept;

}  // namespace tendon::os
