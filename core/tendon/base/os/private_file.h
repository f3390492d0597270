#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string>

namespace tendon::os {

/// Returns the content of a small file of this user, mode 0600, that holds a secret. If it is
/// missing, creates it with `content`; if several processes create it at once, one wins and all
/// return its content. kDenied if it belongs to another user or others may read it.
Result<std::string> ReadOrMakePrivateFile(const std::filesystem::path& file,
                                          const std::string& content);

}  // namespace tendon::os
