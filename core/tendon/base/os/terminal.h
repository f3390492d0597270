#pragma once

namespace tendon::os {

enum class Stream { kInput, kOutput, kError };

/// How many columns the terminal has at which a person sits, 80 where it does not say; 0 where the
/// stream is a pipe or a file.
int TerminalColumns(Stream stream) noexcept;

/// How many lines the terminal at the standard output has, 24 where it does not say.
[[nodiscard]] int TerminalRows() noexcept;

/// Makes sure that the three streams are there, so that no socket gets their numbers: what is
/// written to one that was closed fails. First thing in main().
void GuardStreams() noexcept;

/// Lets a write to a pipe that nobody reads fail, instead of killing the process.
void IgnoreBrokenPipes() noexcept;

}  // namespace tendon::os
