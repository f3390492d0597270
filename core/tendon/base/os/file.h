#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <functional>
#include <string>
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

/// Whether both are to be expected: the folder takes another file, of some bytes, which is gone
/// afterwards, and a file that is there may be written. Waits for the disk; kFailed as the others.
Result<void> CheckWritable(const std::filesystem::path& file);

/// What `read` gives of a file that stays as it is meanwhile. Reads it again where somebody has
/// written it, so that nobody gets half of the old and half of the new; kFailed where that goes on.
Result<std::string> ReadUnchanged(const std::filesystem::path& file,
                                  const std::function<Result<std::string>()>& read);

}  // namespace tendon::os
