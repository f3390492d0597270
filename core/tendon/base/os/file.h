#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string_view>

namespace tendon::os {

/// Writes `text` at the end of a file, which is made when missing, and waits until the disk has it.
Result<void> AppendDurably(const std::filesystem::path& file, std::string_view text);

/// Gives a file new content, whatever happens meanwhile: afterwards it has all of the old or all of
/// the new. Waits for the disk.
Result<void> ReplaceDurably(const std::filesystem::path& file, std::string_view text);

}  // namespace tendon::os
