#pragma once

namespace tendon::os {

enum class Stream { kInput, kOutput, kError };

/// Whether a person sits at the stream, not a pipe or a file.
bool IsTerminal(Stream stream) noexcept;

}  // namespace tendon::os
