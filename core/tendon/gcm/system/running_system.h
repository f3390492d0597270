#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/system_file.h>

#include <string>
#include <vector>

namespace tendon {

/// The running system, as a system file with which it can be restored.
struct RunningSystem {
  SystemFile file;  ///< sorted by name
  /// Connections whose provider's component does not exist. A file cannot contain them.
  std::vector<SystemFile::Connection> loose;

  /// Returns a sentence for each connection that the file cannot contain.
  [[nodiscard]] std::vector<std::string> LeftOut() const;
};

/// Whether to include processes that are gone.
enum class AbsentProcesses { kLeftOut, kIncluded };

/// Returns the present processes, with their components in their present states. A window that
/// hosts the GCM itself is not included.
[[nodiscard]] RunningSystem SystemOf(const Catalogue& catalogue, const std::string& name,
                                     AbsentProcesses absent = AbsentProcesses::kLeftOut);

/// Sets SystemFile::Process::start for the processes that the GCM has started, so that it can start
/// them again from the file.
void SetStarts(const message::Children& children, SystemFile& file);

/// Copies from the file `former` to `saved` what a running system does not contain: comments,
/// "strict", the layout, how processes are started, and absent processes with their connections.
/// Returns a sentence for each absent process.
std::vector<std::string> KeepFrom(const SystemFile& former, RunningSystem& saved);

}  // namespace tendon
