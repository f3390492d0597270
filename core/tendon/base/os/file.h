#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace tendon::os {

/// Appends `text` to a file, which is created if missing, and waits until it is on the disk.
Result<void> AppendDurably(const std::filesystem::path& file, std::string_view text);

/// Gives a file new content. Whatever happens meanwhile, it then has all of the old or all of the
/// new content. An existing file keeps its mode and, if we may set it, its owner. A symbolic link
/// stays a link, and its target is written; further hard links keep the old content. Waits for the
/// disk. kFailed if we may not write the file, it is not regular, or its folder accepts no other
/// file.
Result<void> ReplaceDurably(const std::filesystem::path& file, std::string_view text);

/// Checks if both calls above should succeed: the folder accepts another file of some bytes, which
/// is then removed, and an existing file may be written. Waits for the disk; kFailed as above.
Result<void> CheckWritable(const std::filesystem::path& file);

/// Returns the result of `read` for a file that does not change meanwhile. Reads again if somebody
/// has written it, so that nobody gets half of the old and half of the new; kFailed if that goes
/// on.
Result<std::string> ReadUnchanged(const std::filesystem::path& file,
                                  const std::function<Result<std::string>()>& read);

}  // namespace tendon::os
