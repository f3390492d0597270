#pragma once

#include <tendon/gcm/system_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tendon {

/// A process, component or connection in which two systems differ.
struct SystemDifference {
  enum class Kind {
    kMissing,  ///< only in the first
    kExtra,    ///< only in the second
    kChanged,
  };

  Kind kind = Kind::kChanged;
  std::string what;  ///< "component robot/arm", "connection desk/arm/Robot -> robot/arm/Control"
  std::string how;   ///< kChanged: "class SimulatedArm -> LegacyArm; ..."

  bool operator==(const SystemDifference&) const = default;
};

/// The differences of two systems, in the order of their files.
struct SystemComparison {
  std::vector<SystemDifference> differences;
  std::size_t equal = 0;  ///< processes, components and connections without a difference
};

/// Whether differences in the start of processes count.
enum class StartComparison {
  kCompare,
  kIgnore,  ///< the second system is a running one, which has no information about it
};

/// Compares everything except comments, layout and names of systems. States in which the component
/// does not run count as equal. A period, library or thread that only one of the two has is not a
/// difference.
[[nodiscard]] SystemComparison CompareSystems(const SystemFile& first, const SystemFile& second,
                                              StartComparison starts);

/// "class SimulatedArm -> LegacyArm; state active -> suspended"; empty if they are equal.
[[nodiscard]] std::string ChangesOf(const SystemFile::Component& first,
                                    const SystemFile::Component& second);

/// True if both have the same library, or one has no library.
[[nodiscard]] bool IsSameLibrary(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// True if both run after the same component, or after none, or if one has no information about its
/// thread.
[[nodiscard]] bool HasSameLeader(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// The same, and the thread options are equal.
[[nodiscard]] bool IsSameThread(const SystemFile::Component& one,
                                const SystemFile::Component& other);

/// True if a component in one state satisfies a request for the other state.
[[nodiscard]] bool IsSameDesire(ComponentState one, ComponentState other);

/// True if both are equal as JSON or as text.
[[nodiscard]] bool IsSameJson(const std::string& one, const std::string& other);

}  // namespace tendon
