#pragma once

#include <tendon/gcm/system/system_index.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// Sorts the components so that each comes after its leader, the component after which it runs. The
/// order of other components stays the same. `leader_of` returns the name of the leader; empty if
/// the component has no leader. Components in a cycle, and components that run after them, come
/// last.
void PutLeadersFirst(std::vector<ComponentPath>& order,
                     const std::function<std::string(const ComponentPath& component)>& leader_of);

/// Like the function above, for the components of one process in a file.
void PutLeadersFirst(std::vector<SystemFile::Component>& components);

/// Describes the first cycle among the components of a process: "'a' runs after 'b', which runs
/// after 'a'". Returns an empty text if there is no cycle.
[[nodiscard]] std::string FindCycle(const std::vector<SystemFile::Component>& components);

}  // namespace tendon
