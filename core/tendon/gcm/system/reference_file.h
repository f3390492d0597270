#pragma once

#include <tendon/gcm/system_file.h>

#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// A file of the cisst component manager as a system file.
struct ImportedSystem {
  SystemFile file;
  std::vector<std::string> left_out;  ///< a sentence for each thing that has no counterpart
};

/// Reads what a cisst component manager (1.1) reads: "components" and "connections", alone or
/// within "component-manager", as in a file for the console of a dVRK; comments are passed over.
/// All that names no process goes to `process`. A component that is connected but not made by the
/// file is one that its program makes. Errors as of ParseSystemFile().
Result<ImportedSystem> ParseComponentManagerFile(std::string_view text, const std::string& source,
                                                 const std::string& process);

}  // namespace tendon
