#pragma once

#include <gcm_console/command_line/word_kind.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <vector>

namespace console {

/// All paths of this kind, in order. Of their parents, only those one name longer than `prefix`:
/// "robot/arm/" for "robot/a".
std::vector<std::string> PathsOf(const tendon::Catalogue& catalogue, WordKind kind,
                                 const std::string& prefix);

/// Completes each name of a path to a thing of this kind: "robot/arm/Control.Stop" for "ro/a/C.S".
/// Returns the path unchanged if a name matches no thing or several.
std::string WholePath(const tendon::Catalogue& catalogue, WordKind kind, const std::string& path);

/// The absolute path for `typed`. Usually `typed` is relative to `at`. A path of several names, or
/// one name with a trailing /, is absolute if nothing below `at` matches its first name, but a
/// process does. A single name is never absolute; otherwise a verb would act on a whole process
/// instead of a component that is gone.
std::string PathFrom(const tendon::Catalogue& catalogue, const std::string& at,
                     const std::string& typed);

}  // namespace console
