#pragma once

#include <tendon/gcm/system/system_index.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// Sorts the components so that each comes after its leader, the component after which it runs. The
/// order of other components stays the same. `leader_of` returns the name of the leader; empty if
/// there is none. Components in a cycle, and components that run after them, come last.
void PutLeadersFirst(std::vector<ComponentPath>& order,
                     const std::function<std::string(const ComponentPath& component)>& leader_of);

/// Sorts the components of one process in a file in the same way.
void PutLeadersFirst(std::vector<SystemFile::Component>& components);

/// Describes the first cycle among the components of a process: "'a' runs after 'b', which runs
/// after 'a'"; empty if there is no cycle.
[[nodiscard]] std::string FindCycle(const std::vector<SystemFile::Component>& components);

}  // namespace tendon
