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

/// A whole system as a user writes it down: which components run in which processes, in which
/// state, and what is connected. JSON, version 1:
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
/// A component may also have "configuration" (what its constructor is given), "period" (s, which
/// its class has chosen: to compare, not to set), "thread" (fields of ThreadOptions), "runs_after"
/// (a task of its process, in whose thread and cycle it runs), and "state": "active" unless it says
/// "suspended", "finished" or "constructed". One that has "thread", but not "runs_after", runs in a
/// thread of its own; one that has neither runs as its class chooses. A "class" of null is that of
/// a component which its own program makes. A process with "start", such as {"restart":
/// "on-failure"} or {}, which is to restart never, is an `lcm` that the GCM starts on its own host.
/// With "strict": true no component is started that lacks the connection of a required interface
/// which it needs; otherwise it runs, and waits for that. Everything may have a "comment". What a
/// component may have may be missing, and so may "connections", "layout" and "strict".
struct SystemFile {
  /// One to make, and how.
  struct Component {
    std::string name;
    std::string class_name;     ///< empty: only its own program makes it
    std::string library;        ///< of a plug-in, without path; empty: one that has the class
    std::string configuration;  ///< JSON text for the class to check, or empty for its defaults
    double period = 0.0;        ///< s; 0 where it is not known, or has none
    std::optional<ThreadOptions> thread{};
    std::string runs_after{};  ///< the component after which it runs, or empty
    /// The desired one of kDesirable; any, where it was taken from what runs.
    ComponentState state = ComponentState::kActive;
    std::string comment{};

    /// Whether it is known in which thread it runs.
    [[nodiscard]] bool tells_thread() const { return thread || !runs_after.empty(); }

    bool operator==(const Component&) const = default;
  };
  /// How the GCM starts a process on its own host.
  struct Start {
    RestartPolicy restart = RestartPolicy::kNever;

    bool operator==(const Start&) const = default;
  };
  /// What one process runs.
  struct Process {
    std::string name;
    std::vector<Component> components;
    std::string comment{};
    std::optional<Start> start{};  ///< nothing: somebody else starts it

    bool operator==(const Process&) const = default;
  };
  /// Two ends, each `process/component/interface`.
  struct Connection {
    InterfaceName required;
    InterfaceName provided;
    std::string comment{};

    bool operator==(const Connection&) const = default;
  };
  /// Of a component in the graph.
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

  /// Null where there is none; by looking at all, unlike a SystemIndex.
  [[nodiscard]] const Process* FindProcess(const std::string& process_name) const;
  [[nodiscard]] const Component* FindComponent(const std::string& process_name,
                                               const std::string& component_name) const;

  bool operator==(const SystemFile&) const = default;

  static constexpr int kVersion = 1;
  static constexpr std::size_t kMaxSize = std::size_t{16} << 20U;           // bytes
  static constexpr std::size_t kMaxConfiguration = std::size_t{64} << 10U;  // bytes, in one line
  /// The states that a component can be brought to, or left in.
  static constexpr std::array kDesirable = {ComponentState::kActive, ComponentState::kSuspended,
                                            ComponentState::kFinished,
                                            ComponentState::kConstructed};
};

/// Strict: what it does not understand is an error, which says where: "demo.json: line 12, column
/// 5: unexpected ','" or "demo.json: line 7, column 20: processes[0].components[1].class: expected
/// string, got number". The code is kNotFound for a missing file, else kInvalid.
Result<SystemFile> ReadSystemFile(const std::filesystem::path& path);

/// What is in the file, which must be a regular one; of one that is too large no more than tells.
Result<std::string> ReadSystemText(const std::filesystem::path& path);

/// `source` is what errors begin with.
Result<SystemFile> ParseSystemFile(std::string_view text, const std::string& source);

/// The text that reads back as `system`, a faulted component of which is to be active; kInvalid
/// where there is none, since a configuration is no JSON, or too long.
Result<std::string> SystemFileText(const SystemFile& system);

/// Replaces the file, wholly or not at all; os::ReplaceDurably() says what stays of one that is
/// there. kInvalid as SystemFileText(), else kFailed.
Result<void> WriteSystemFile(const std::filesystem::path& path, const SystemFile& system);

}  // namespace tendon
