#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/system_file.h>

#include <string>
#include <vector>

namespace tendon {

/// The running system as a system file, from which it can be restored.
struct RunningSystem {
  SystemFile file;  ///< sorted by name
  /// Connections whose provider's component does not exist. A file cannot contain them.
  std::vector<SystemFile::Connection> loose;

  /// Returns a sentence for each connection that is not in the file.
  [[nodiscard]] std::vector<std::string> LeftOut() const;
};

/// Whether to include absent processes.
enum class AbsentProcesses { kLeftOut, kIncluded };

/// Returns the present processes, with their components in their present states. Does not include a
/// window that hosts the GCM itself.
[[nodiscard]] RunningSystem SystemOf(const Catalogue& catalogue, const std::string& name,
                                     AbsentProcesses absent = AbsentProcesses::kLeftOut);

/// Sets SystemFile::Process::start for the processes that the GCM has started. Then the GCM can
/// start them again from the file.
void SetStarts(const message::Children& children, SystemFile& file);

/// Copies the parts that a running system does not have from the file `former` to `saved`:
/// comments, "strict", the layout, how processes are started, and absent processes with their
/// connections. Returns a sentence for each absent process.
std::vector<std::string> KeepFrom(const SystemFile& former, RunningSystem& saved);

}  // namespace tendon
