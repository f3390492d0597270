#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/system_file.h>

#include <string>
#include <vector>

namespace tendon {

/// The running system, as a file that can restore it.
struct RunningSystem {
  SystemFile file;  ///< sorted by name
  /// Connections to absent components, which a file cannot contain.
  std::vector<SystemFile::Connection> loose;

  /// A sentence for each part that the file cannot contain.
  [[nodiscard]] std::vector<std::string> LeftOut() const;
};

/// Whether to include processes that are gone.
enum class AbsentProcesses { kLeftOut, kIncluded };

/// The present processes, with their components in their present states; without a window that
/// hosts the GCM itself.
[[nodiscard]] RunningSystem SystemOf(const Catalogue& catalogue, const std::string& name,
                                     AbsentProcesses absent = AbsentProcesses::kLeftOut);

/// Marks the processes that the GCM has started, so that it can start them again.
void SetStarts(const message::Children& children, SystemFile& file);

/// Copies from the saved file `former` everything that a running system does not show: comments,
/// layout, how processes start, and absent processes with their connections. Returns a sentence for
/// each absent process.
std::vector<std::string> KeepFrom(const SystemFile& former, RunningSystem& saved);

}  // namespace tendon
