#pragma once

#include <tendon/gcm/system/system_index.h>

#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// Puts each component behind the one after which it runs, and so behind the one after which that
/// runs; else the order stays. `leader_of` tells that one's name, or nothing. Those that run after
/// themselves in the end, or after such a one, come last.
void PutLeadersFirst(std::vector<ComponentPath>& order,
                     const std::function<std::string(const ComponentPath& component)>& leader_of);

/// For the components of one process in a file.
void PutLeadersFirst(std::vector<SystemFile::Component>& components);

/// "'a' runs after 'b', which runs after 'a'", for the first ring there is among the components of
/// a process; empty where there is none.
[[nodiscard]] std::string FindRingIn(const std::vector<SystemFile::Component>& components);

}  // namespace tendon
