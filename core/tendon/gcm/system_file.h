#pragma once

#include <tendon/base/name.h>
#include <tendon/base/result.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// A whole system as a user writes it down: which components run in which processes, and what is
/// connected. JSON, version 1:
///
///     {
///       "version": 1,
///       "name": "demo",
///       "processes": [
///         {"name": "robot",
///          "components": [{"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"}]}
///       ],
///       "connections": [
///         {"required": "desk/teleoperation/Robot", "provided": "robot/arm/Control"}
///       ]
///     }
///
/// "library" (of a plug-in, without path), "configuration" (of a component) and "connections" may
/// be missing.
struct SystemFile {
  /// One to make, and how.
  struct Component {
    std::string name;
    std::string class_name;
    std::string library;        ///< empty: the class is in the program
    std::string configuration;  ///< JSON text for the class to check, or empty

    bool operator==(const Component&) const = default;
  };
  /// What one process runs.
  struct Process {
    std::string name;
    std::vector<Component> components;

    bool operator==(const Process&) const = default;
  };
  /// Two ends, each `process/component/interface`.
  struct Connection {
    InterfaceName required;
    InterfaceName provided;

    bool operator==(const Connection&) const = default;
  };

  std::string name;
  std::vector<Process> processes;
  std::vector<Connection> connections;

  /// Null where there is none.
  [[nodiscard]] const Process* FindProcess(const std::string& process_name) const;

  bool operator==(const SystemFile&) const = default;

  static constexpr int kVersion = 1;
  static constexpr std::size_t kMaxSize = std::size_t{16} << 20U;  // bytes
};

/// Strict: what it does not understand is an error, which says where: "demo.json: line 12, column
/// 5: unexpected ','" or "demo.json: processes[0].components[1].class: expected text, got number".
/// The code is kNotFound for a missing file, else kInvalid.
Result<SystemFile> ReadSystemFile(const std::filesystem::path& path);

/// `source` is what errors begin with.
Result<SystemFile> ParseSystemFile(std::string_view text, const std::string& source);

/// The text that reads back as `system`; kInvalid where a configuration is no JSON.
Result<std::string> SystemFileText(const SystemFile& system);

/// Replaces the file, wholly or not at all.
Result<void> WriteSystemFile(const std::filesystem::path& path, const SystemFile& system);

}  // namespace tendon
