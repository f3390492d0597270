#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/manager/unmet_need.h>

#include <string>
#include <vector>

namespace tendon {

/// What a component waits for: it runs, and lacks the connection of a required interface that it
/// needs, so that it cannot do its work. Empty where it does not run, or where `process`, which is
/// its own, is not there. The judgement of every program.
[[nodiscard]] std::vector<UnmetNeed> WaitsOf(const ProcessEntry& process,
                                             const ComponentDescription& component);

/// The same for who finds connections faster than by looking at all of the process.
[[nodiscard]] std::vector<UnmetNeed> WaitsOf(const ProcessEntry& process,
                                             const ComponentDescription& component,
                                             const FindConnection& find);

/// What it would wait for if it ran.
[[nodiscard]] std::vector<UnmetNeed> UnmetNeedsOf(const ProcessEntry& process,
                                                  const ComponentDescription& component);

/// "waiting for Robot, Camera", or nothing.
[[nodiscard]] std::string WaitingText(const std::vector<UnmetNeed>& waits);

/// "waiting for Robot: not connected", or nothing.
[[nodiscard]] std::string WaitingReasons(const std::vector<UnmetNeed>& waits);

/// "active, waiting for Robot": the state of a component, and what keeps it from its work.
[[nodiscard]] std::string StateText(const ProcessEntry& process,
                                    const ComponentDescription& component);

}  // namespace tendon
