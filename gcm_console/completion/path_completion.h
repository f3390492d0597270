#pragma once

#include <gcm_console/command_line/word_kind.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <vector>

namespace console {

/// Returns the paths of this kind that begin with `prefix`, in order. Of a longer path, only the
/// part up to the next name after `prefix` is returned: "robot/arm/" for the prefix "robot/a".
std::vector<std::string> PathsOf(const tendon::Catalogue& catalogue, WordKind kind,
                                 const std::string& prefix);

/// Completes each name in a path of an object of this kind: "robot/arm/Control.Stop" for
/// "ro/a/C.S". If a name matches no object or several, returns the path unchanged.
std::string WholePath(const tendon::Catalogue& catalogue, WordKind kind, const std::string& path);

/// Returns the absolute path for `typed`. Usually `typed` is relative to `at`. However, `typed` is
/// absolute if all of these are true: it has several names (or one name with a trailing /), its
/// first name matches nothing below `at`, and its first name matches a process. A single name is
/// never absolute: if the component that the user means is gone, the verb would otherwise act on a
/// whole process.
std::string PathFrom(const tendon::Catalogue& catalogue, const std::string& at,
                     const std::string& typed);

}  // namespace console
