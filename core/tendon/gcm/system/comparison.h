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

/// Whether the second of two systems knows how its processes start.
enum class Starts {
  kKnown,            ///< it is a file
  kUnknownInSecond,  ///< it is a running system; not compared
};

/// Compares everything but comments, layout and names. States in which nothing runs count as equal.
/// A period, library or thread that only one of the two mentions is no difference.
[[nodiscard]] SystemComparison CompareSystems(const SystemFile& first, const SystemFile& second,
                                              Starts starts);

/// "class SimulatedArm -> LegacyArm; state active -> suspended"; empty if they are equal.
[[nodiscard]] std::string ChangesOf(const SystemFile::Component& first,
                                    const SystemFile::Component& second);

/// Whether both have the same library, or one does not say.
[[nodiscard]] bool IsSameLibrary(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// Whether both run after the same component, or none, or one does not say how it runs.
[[nodiscard]] bool HasSameLeader(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// The same, and with the same thread options.
[[nodiscard]] bool IsSameThread(const SystemFile::Component& one,
                                const SystemFile::Component& other);

/// Whether a component in one state satisfies a wish for the other.
[[nodiscard]] bool IsSameDesire(ComponentState one, ComponentState other);

/// Whether both are the same JSON or the same text.
[[nodiscard]] bool IsSameJson(const std::string& one, const std::string& other);

}  // namespace tendon
