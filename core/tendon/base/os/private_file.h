#pragma once

#include <tendon/base/result.h>

#include <filesystem>
#include <string>

namespace tendon::os {

/// The content of a small file of this user, mode 0600, that holds a secret. Where it is missing it
/// is made with `content`; of several makers at once one wins and all return what it wrote. kDenied
/// where it belongs to somebody else or others may read it.
Result<std::string> ReadOrMakePrivateFile(const std::filesystem::path& file,
                                          const std::string& content);

}  // namespace tendon::os
