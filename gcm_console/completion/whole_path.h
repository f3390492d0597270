#pragma once

#include <gcm_console/line/word_kind.h>
#include <tendon/gcm/catalog.h>

#include <string>

namespace console {

/// "robot/arm/Control.Stop" for "ro/a/C.S": each name of a path to something of that kind, where
/// only one begins so. The path as it is where a name is that of nothing, or of several.
std::string WholePath(const tendon::Catalog& catalog, WordKind kind, const std::string& path);

/// The path of `typed` for who stands `at` another: below that. Several names, or one with a /
/// behind it, are a path from the top where nothing below begins like the first while a process is
/// called so; one name alone never is, for a verb would act on a whole process instead of what is
/// gone.
std::string PathFrom(const tendon::Catalog& catalog, const std::string& at,
                     const std::string& typed);

}  // namespace console
