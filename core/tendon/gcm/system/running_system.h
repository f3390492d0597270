#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/supervisor/children_messages.h>
#include <tendon/gcm/system_file.h>

#include <string>
#include <vector>

namespace tendon {

/// What runs, as a file that makes it again.
struct RunningSystem {
  SystemFile file;  ///< in the order of names
  /// To what is not there: a file cannot hold them.
  std::vector<SystemFile::Connection> loose;

  /// A sentence for each thing that the file cannot hold.
  [[nodiscard]] std::vector<std::string> LeftOut() const;
};

/// What becomes of processes that are not there any more.
enum class Gone { kLeftOut, kIncluded };

/// The processes that are there, but for a window that is the GCM itself, with their components in
/// the states that they are in.
[[nodiscard]] RunningSystem SystemOf(const Catalog& catalog, const std::string& name,
                                     Gone gone = Gone::kLeftOut);

/// Marks those that the GCM has started as such, so that it can start them again.
void SetStarts(const message::Children& children, SystemFile& file);

/// Keeps what a running system does not tell, and the file that it is saved to knows: comments,
/// layout, who starts a process, and whole processes that are not there now, with their
/// connections. Returns a sentence for each of those processes.
std::vector<std::string> KeepFrom(const SystemFile& former, RunningSystem& saved);

}  // namespace tendon
