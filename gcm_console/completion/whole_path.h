#pragma once

#include <gcm_console/line/word_kind.h>
#include <tendon/gcm/catalog.h>

#include <string>

namespace console {

/// "robot/arm/Control.Stop" for "ro/a/C.S": each name of a path to something of that kind, where
/// only one begins so. The path as it is where a name is that of nothing, or of several.
std::string WholePath(const tendon::Catalog& catalog, WordKind kind, const std::string& path);

/// The path of `typed` for who stands `at` another: below that, unless there is nothing of its first
/// name while a process is called so: then it is a path from the top.
std::string PathFrom(const tendon::Catalog& catalog, const std::string& at,
                     const std::string& typed);

}  // namespace console
