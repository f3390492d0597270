#pragma once

#include <tendon/gcm/system_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tendon {

/// A process, component or connection that is not the same in two systems.
struct SystemDifference {
  enum class Kind {
    kMissing,  ///< only in the first system
    kExtra,    ///< only in the second system
    kChanged,
  };

  Kind kind = Kind::kChanged;
  std::string what;  ///< "component robot/arm", "connection desk/arm/Robot -> robot/arm/Control"
  std::string how;   ///< kChanged: "class SimulatedArm -> LegacyArm; ..."

  bool operator==(const SystemDifference&) const = default;
};

/// The differences of two systems, in the order of the two files.
struct SystemComparison {
  std::vector<SystemDifference> differences;
  std::size_t equal = 0;  ///< processes, components and connections without a difference
};

/// Selects whether differences in the way the GCM starts processes are reported.
enum class StartComparison {
  kCompare,
  kIgnore,  ///< set if the second system is a running system, which lacks this information
};

/// Compares two systems, except for their comments, layouts and names. All states in which a
/// component does not run count as equal. A period, library or thread that only one of the two
/// systems has for a component does not count as a difference.
[[nodiscard]] SystemComparison CompareSystems(const SystemFile& first, const SystemFile& second,
                                              StartComparison starts);

/// The differences of two components: "class SimulatedArm -> LegacyArm; state active -> suspended";
/// empty if they are equal.
[[nodiscard]] std::string ChangesOf(const SystemFile::Component& first,
                                    const SystemFile::Component& second);

/// Returns true if both have the same library, or if one of the two has no library.
[[nodiscard]] bool IsSameLibrary(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// Returns true if both run after the same component, or if neither runs after another component.
/// Also returns true if the thread of one component is not known.
[[nodiscard]] bool HasSameLeader(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// Returns true if HasSameLeader() is true and the thread options, if both have them, are equal.
[[nodiscard]] bool IsSameThread(const SystemFile::Component& one,
                                const SystemFile::Component& other);

/// Returns true if the two states are equal, or if the component runs in neither.
[[nodiscard]] bool SatisfiesSameRequest(ComponentState one, ComponentState other);

/// Returns true if both texts are equal, or if both are equal as JSON.
[[nodiscard]] bool IsSameJson(const std::string& one, const std::string& other);

}  // namespace tendon
