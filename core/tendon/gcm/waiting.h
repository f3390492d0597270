#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/manager/unsatisfied_interface.h>

#include <string>
#include <vector>

namespace tendon {

/// The required interfaces that a running component needs, and that are not connected. Empty if the
/// component does not run, or if its process is absent. All programs use this.
[[nodiscard]] std::vector<UnsatisfiedInterface> WaitsOf(const ProcessEntry& process,
                                                        const ComponentDescription& component);

/// The same; `find` finds connections faster than a search in `process`.
[[nodiscard]] std::vector<UnsatisfiedInterface> WaitsOf(const ProcessEntry& process,
                                                        const ComponentDescription& component,
                                                        const FindConnection& find);

/// The required interfaces that the component would wait for if it ran.
[[nodiscard]] std::vector<UnsatisfiedInterface> UnmetNeedsOf(const ProcessEntry& process,
                                                             const ComponentDescription& component);

/// "waiting for Robot, Camera", or empty.
[[nodiscard]] std::string WaitingText(const std::vector<UnsatisfiedInterface>& waits);

/// "waiting for Robot: not connected", or empty.
[[nodiscard]] std::string WaitingReasons(const std::vector<UnsatisfiedInterface>& waits);

/// "active, waiting for Robot": the state of a component, and why it cannot work.
[[nodiscard]] std::string StateText(const ProcessEntry& process,
                                    const ComponentDescription& component);

}  // namespace tendon
