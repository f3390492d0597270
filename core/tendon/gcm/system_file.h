#pragma once

#include <tendon/base/name.h>
#include <tendon/base/result.h>
#include <tendon/gcm/supervisor/restart_policy.h>
#include <tendon/task/component_state.h>
#include <tendon/task/thread_options.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// The description of a whole system, which a user writes or saves. It lists the processes, their
/// components with their states, and the connections. The file is JSON, version 1:
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
///       ],
///       "layout": {"robot/arm": [120, 40]}
///     }
///
/// A component may also have these keys:
/// - "configuration" is the argument for its constructor.
/// - "period" is in s. The class sets the period; this value is only compared with the period of
///   the class.
/// - "thread" has fields of ThreadOptions.
/// - "runs_after" names a task of the same process. The component runs in the thread and in the
///   cycles of this task.
/// - "state" is "active" (the default), "suspended", "finished" or "constructed".
///
/// A component with "thread" but without "runs_after" has its own thread. Without both keys, its
/// class decides. If "class" is null, the program of the process creates the component itself.
///
/// A process with "start" is an `lcm` that the GCM starts on its own host: {"restart":
/// "on-failure"}, or {} for no restarts. With "strict": true, a component is started only if the
/// connections that it needs are made; otherwise it runs and waits for them. Each object may have a
/// "comment". All these keys, "connections" and "layout" are optional.
struct SystemFile {
  /// A component to create.
  struct Component {
    std::string name;
    std::string class_name;  ///< empty if the program of the process creates it itself
    /// The name of the plug-in without a path. If empty, any plug-in that has the class is used.
    std::string library;
    std::string configuration;  ///< JSON, checked by the class; if empty, the class uses its
                                ///< defaults
    double period = 0.0;        ///< s; 0 if unknown or not periodic
    std::optional<ThreadOptions> thread{};
    std::string runs_after{};  ///< the component after which this one runs, or empty
    /// The desired state, which is one of kDesirable. For a component of a running system, the
    /// present state, which can be any state.
    ComponentState state = ComponentState::kActive;
    std::string comment{};

    /// Returns true if the file describes the thread of the component with `thread` or
    /// `runs_after`.
    [[nodiscard]] bool tells_thread() const { return thread || !runs_after.empty(); }

    bool operator==(const Component&) const = default;
  };
  /// How the GCM starts a process on its own host.
  struct Start {
    RestartPolicy restart = RestartPolicy::kNever;

    bool operator==(const Start&) const = default;
  };
  /// The components of one process.
  struct Process {
    std::string name;
    std::vector<Component> components;
    std::string comment{};
    std::optional<Start> start{};  ///< empty if the GCM does not start the process

    bool operator==(const Process&) const = default;
  };
  /// A connection. Both names have the form `process/component/interface`.
  struct Connection {
    InterfaceName required;
    InterfaceName provided;
    std::string comment{};

    bool operator==(const Connection&) const = default;
  };
  /// The position of a component in the graph.
  struct Position {
    double x = 0.0;
    double y = 0.0;

    bool operator==(const Position&) const = default;
  };

  std::string name;
  std::vector<Process> processes;
  std::vector<Connection> connections;
  std::map<std::string, Position> layout{};  ///< by "process/component"
  std::string comment{};
  bool strict = false;

  /// The Find functions return null if the object is not in the file. They search linearly;
  /// SystemIndex is faster.
  [[nodiscard]] const Process* FindProcess(const std::string& process_name) const;
  [[nodiscard]] const Component* FindComponent(const std::string& process_name,
                                               const std::string& component_name) const;

  bool operator==(const SystemFile&) const = default;

  static constexpr int kVersion = 1;
  static constexpr std::size_t kMaxSize = std::size_t{16} << 20U;           // bytes
  static constexpr std::size_t kMaxConfiguration = std::size_t{64} << 10U;  // bytes, on one line
  /// The states that can be requested for a component.
  static constexpr std::array kDesirable = {ComponentState::kActive, ComponentState::kSuspended,
                                            ComponentState::kFinished,
                                            ComponentState::kConstructed};
};

/// Reads a system file. Unknown keys and invalid values are errors. The error gives the position:
/// "demo.json: line 12, column 5: unexpected ','" or "demo.json: line 7, column 20:
/// processes[0].components[1].class: expected string, got number". The code is kNotFound for a
/// missing file, otherwise kInvalid.
Result<SystemFile> ReadSystemFile(const std::filesystem::path& path);

/// Returns the content of the file, which must be a regular file. Reads at most one byte more than
/// kMaxSize.
Result<std::string> ReadSystemText(const std::filesystem::path& path);

/// Parses the text of a system file. Error messages begin with `source`.
Result<SystemFile> ParseSystemFile(std::string_view text, const std::string& source);

/// Returns a text from which `system` can be read again. The state of a faulted component is
/// written as active. Fails with kInvalid if a configuration is not JSON or is too long.
Result<std::string> SystemFileText(const SystemFile& system);

/// Writes the file. An existing file is replaced completely or not at all; see
/// os::ReplaceDurably(). Fails with kInvalid like SystemFileText(), otherwise with kFailed.
Result<void> WriteSystemFile(const std::filesystem::path& path, const SystemFile& system);

}  // namespace tendon
