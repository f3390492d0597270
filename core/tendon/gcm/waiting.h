#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/manager/unsatisfied_interface.h>

#include <string>
#include <vector>

namespace tendon {

/// Returns the required interfaces that a running component needs and that are not connected.
/// Returns an empty list if the component does not run or its process is absent. All programs use
/// this function.
[[nodiscard]] std::vector<UnsatisfiedInterface> WaitsOf(const ProcessEntry& process,
                                                        const ComponentDescription& component);

/// Like the function above, but with a function `find` that finds a connection faster than a search
/// in `process`.
[[nodiscard]] std::vector<UnsatisfiedInterface> WaitsOf(const ProcessEntry& process,
                                                        const ComponentDescription& component,
                                                        const FindConnection& find);

/// Returns the required interfaces for which the component would wait if it ran.
[[nodiscard]] std::vector<UnsatisfiedInterface> UnmetNeedsOf(const ProcessEntry& process,
                                                             const ComponentDescription& component);

/// Returns "waiting for Robot, Camera"; empty if `waits` is empty.
[[nodiscard]] std::string WaitingText(const std::vector<UnsatisfiedInterface>& waits);

/// Returns "waiting for Robot: not connected"; empty if `waits` is empty.
[[nodiscard]] std::string WaitingReasons(const std::vector<UnsatisfiedInterface>& waits);

/// The state of a component and the interfaces for which it waits: "active, waiting for Robot".
[[nodiscard]] std::string StateText(const ProcessEntry& process,
                                    const ComponentDescription& component);

}  // namespace tendon
