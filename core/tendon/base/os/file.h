#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string_view>

namespace tendon::os {

/// Writes `text` at the end of a file, which is made when missing, and waits until the disk has it.
Result<void> AppendDurably(const std::filesystem::path& file, std::string_view text);

/// Gives a file new content, whatever happens meanwhile: afterwards it has all of the old or all of
/// the new. One that is there keeps its mode and, where we may give it that, its owner; a symbolic
/// link stays one, and what it leads to is written; further hard links keep the old content. Waits
/// for the disk. kFailed where the file is none of ours to write, no regular one, or its folder
/// takes no other file.
Result<void> ReplaceDurably(const std::filesystem::path& file, std::string_view text);

}  // namespace tendon::os
