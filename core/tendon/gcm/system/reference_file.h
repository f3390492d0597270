#pragma once

#include <tendon/gcm/system_file.h>

#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// A file of the cisst component manager, as a system file.
struct ImportedSystem {
  SystemFile file;
  std::vector<std::string> left_out;  ///< a sentence for each part without a counterpart
};

/// Reads a file of a cisst component manager (1.1): "components" and "connections", alone or within
/// "component-manager", as in a file for the console of a dVRK; ignores comments. Everything
/// without a process goes to `process`. A component that is connected but not created by the file
/// belongs to its program. Errors as of ParseSystemFile().
Result<ImportedSystem> ParseComponentManagerFile(std::string_view text, const std::string& source,
                                                 const std::string& process);

}  // namespace tendon
