#pragma once

#include <gcm_console/line/word_kind.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// Completes each name of a path to a thing of this kind: "robot/arm/Control.Stop" for "ro/a/C.S".
/// Returns the path unchanged if a name matches no thing or several.
std::string WholePath(const tendon::Catalogue& catalogue, WordKind kind, const std::string& path);

/// The absolute path of `typed` for a user whose relative paths begin `at` another: usually below
/// it. A path of several names, or one name with a trailing /, is absolute if nothing below `at`
/// matches its first name and a process does. One name alone is never absolute: a verb would
/// otherwise act on a whole process instead of a component that is gone.
std::string PathFrom(const tendon::Catalogue& catalogue, const std::string& at,
                     const std::string& typed);

}  // namespace console
