#pragma once

#include <tendon/gcm/system_file.h>

#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// A file of the cisst component manager, converted to a system file.
struct ImportedSystem {
  SystemFile file;
  std::vector<std::string> left_out;  ///< a sentence for each part without a counterpart
};

/// Reads a file of a cisst component manager (1.1): "components" and "connections", at the top
/// level or within "component-manager", as in a file for the console of a dVRK; ignores comments.
/// Components without a process are put into `process`. A component that the file connects but does
/// not create must be created by its own program. Errors are those of ParseSystemFile().
Result<ImportedSystem> ParseComponentManagerFile(std::string_view text, const std::string& source,
                                                 const std::string& process);

}  // namespace tendon
