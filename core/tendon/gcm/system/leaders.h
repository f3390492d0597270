#pragma once

#include <tendon/gcm/system/system_index.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// Moves each component behind its leader, the component after which it runs; otherwise keeps the
/// order. `leader_of` returns the leader's name, or an empty text. Components in a cycle, or behind
/// one, come last.
void PutLeadersFirst(std::vector<ComponentPath>& order,
                     const std::function<std::string(const ComponentPath& component)>& leader_of);

/// For the components of one process in a file.
void PutLeadersFirst(std::vector<SystemFile::Component>& components);

/// "'a' runs after 'b', which runs after 'a'" for the first cycle among the components of a
/// process; empty if there is none.
[[nodiscard]] std::string FindCycle(const std::vector<SystemFile::Component>& components);

}  // namespace tendon
