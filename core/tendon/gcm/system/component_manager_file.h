#pragma once

#include <tendon/gcm/system_file.h>

#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// The content of a file of the cisst component manager, converted to a system file.
struct ImportedSystem {
  SystemFile file;
  /// A sentence for each part that a system file cannot contain.
  std::vector<std::string> left_out;
};

/// Converts the text of a file of a cisst component manager (1.1). Reads "components" and
/// "connections", which are at the top level or inside "component-manager", as in a file for the
/// console of a dVRK. Comments are ignored. Components without a process in the file are put into
/// `process`. A component that is only connected, not created, must be created by the program of
/// its process. Fails like ParseSystemFile().
Result<ImportedSystem> ParseComponentManagerFile(std::string_view text, const std::string& source,
                                                 const std::string& process);

}  // namespace tendon
