#pragma once

#include <tendon/base/name.h>
#include <tendon/base/result.h>
#include <tendon/gcm/supervisor/restart_policy.h>
#include <tendon/task/component_state.h>
#include <tendon/task/thread_options.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// The description of a whole system by its user: which components run in which processes, in which
/// state, and their connections. JSON, version 1:
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
/// A component may also have "configuration" (for its constructor), "period" (in s, chosen by its
/// class; only compared, never set), "thread" (fields of ThreadOptions), "runs_after" (a task of
/// its process, in whose thread and cycle it runs), and "state": "active" by default, or
/// "suspended", "finished" or "constructed". With "thread" but no "runs_after", it runs in a thread
/// of its own; with neither, its class chooses. A "class" of null means that its own program
/// creates the component. A process with "start" is an `lcm` that the GCM starts on its own host:
/// {"restart": "on-failure"}, or {} for no restarts. With "strict": true a component is not started
/// without the connections that it needs; otherwise it runs and waits for them. Each object may
/// have a "comment". All these keys of a component are optional, and so are "connections", "layout"
/// and "strict".
struct SystemFile {
  /// A component to create.
  struct Component {
    std::string name;
    std::string class_name;     ///< empty: created only by its own program
    std::string library;        ///< plug-in name without path; empty: any plug-in with the class
    std::string configuration;  ///< JSON that the class checks; empty for its defaults
    double period = 0.0;        ///< s; 0 if it is unknown or there is none
    std::optional<ThreadOptions> thread{};
    std::string runs_after{};  ///< the component after which it runs, or empty
    /// The desired state, one of kDesirable; any state if taken from a running system.
    ComponentState state = ComponentState::kActive;
    std::string comment{};

    /// True if it is known in which thread the component runs.
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
    std::optional<Start> start{};  ///< empty: not started by the GCM

    bool operator==(const Process&) const = default;
  };
  /// A connection with its two ends, each `process/component/interface`.
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

  /// Null if there is none. Linear search, unlike SystemIndex.
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

/// Reads a file. Unknown content is an error, with its place: "demo.json: line 12, column 5:
/// unexpected ','" or "demo.json: line 7, column 20: processes[0].components[1].class: expected
/// string, got number". The code is kNotFound for a missing file, else kInvalid.
Result<SystemFile> ReadSystemFile(const std::filesystem::path& path);

/// The content of the file, which must be a regular one; cut just above kMaxSize.
Result<std::string> ReadSystemText(const std::filesystem::path& path);

/// Errors begin with `source`.
Result<SystemFile> ParseSystemFile(std::string_view text, const std::string& source);

/// The text of a file from which `system` can be read again, except that a faulted component
/// becomes active. kInvalid if a configuration is not JSON or is too long.
Result<std::string> SystemFileText(const SystemFile& system);

/// Replaces the file completely or not at all; see os::ReplaceDurably(). Errors: kInvalid as in
/// SystemFileText(), otherwise kFailed.
Result<void> WriteSystemFile(const std::filesystem::path& path, const SystemFile& system);

}  // namespace tendon
