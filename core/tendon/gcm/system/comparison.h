#pragma once

#include <tendon/gcm/system_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace tendon {

/// A process, component or connection in which two systems differ.
struct SystemDifference {
  enum class Kind {
    kMissing,  ///< only the first has it
    kExtra,    ///< only the second has it
    kChanged,
  };

  Kind kind = Kind::kChanged;
  std::string what;  ///< "component robot/arm", "connection desk/arm/Robot -> robot/arm/Control"
  std::string how;   ///< kChanged: "class SimulatedArm -> LegacyArm; ..."

  bool operator==(const SystemDifference&) const = default;
};

/// In what two systems differ, in the order of their files.
struct SystemComparison {
  std::vector<SystemDifference> differences;
  std::size_t equal = 0;  ///< processes, components and connections without a difference
};

/// Whether the second of two systems says who starts its processes.
enum class Starts {
  kKnown,            ///< it is a file
  kUnknownInSecond,  ///< it runs, and does not tell: that is not compared
};

/// Of everything that makes a system what it is: comments, layout and name do not. Of the states
/// those in which nothing runs are one. A period, a library or a thread that one of the two does
/// not mention is no difference.
[[nodiscard]] SystemComparison CompareSystems(const SystemFile& first, const SystemFile& second,
                                              Starts starts);

/// "class SimulatedArm -> LegacyArm; state active -> suspended"; empty where they are the same.
[[nodiscard]] std::string ChangesOf(const SystemFile::Component& first,
                                    const SystemFile::Component& second);

/// Whether both are of the same library, or one does not say which.
[[nodiscard]] bool IsSameLibrary(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// Whether both run after the same other one, or none, or one does not say how it runs.
[[nodiscard]] bool HasSameLeader(const SystemFile::Component& one,
                                 const SystemFile::Component& other);

/// The same, and in threads of the same options.
[[nodiscard]] bool IsSameThread(const SystemFile::Component& one,
                                const SystemFile::Component& other);

/// Whether a component in the one state is as wanted by the other.
[[nodiscard]] bool IsSameDesire(ComponentState one, ComponentState other);

/// Whether both say the same JSON, or are the same text.
[[nodiscard]] bool IsSameJson(const std::string& one, const std::string& other);

}  // namespace tendon
