#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system_file.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/membership_messages.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// One change of a running system.
struct PlanStep {
  enum class Kind {
    kStop,
    kSuspend,
    kDisconnect,
    kRemove,
    kStartProcess,  ///< without components, on the GCM's host
    kConfigure,     ///< creates a stopped component again; its connections stay
    kCreate,
    kConnect,
    kReplace,  ///< replaces the connection of a required interface
    kStart,
    kStartSuspended,  ///< starts, then suspends
    kEndProcess,      ///< ends a process that the GCM has started
  };

  Kind kind = Kind::kConnect;
  message::Wire wire{};        ///< for connections: the ends
  std::string process{};       ///< for components: their process; for processes: the name
  std::uint64_t instance = 0;  ///< of the executing process, at planning; 0: a step starts it
  SystemFile::Component component{};   ///< for components; to create one: as in the file
  std::vector<message::Wire> needs{};  ///< to start: connections that must exist before
  /// To start a process: its policy. To end a process: its former policy, so that an undo can start
  /// it again.
  RestartPolicy restart = RestartPolicy::kNever;
  bool is_strict = false;   ///< to start: refuse if a connection that it needs is missing
  bool takes_away = false;  ///< stops or disconnects a working part
  Fingerprint based_on{};   ///< to configure: BaseOf() the present configuration

  bool operator==(const PlanStep&) const = default;
};

/// "create", "connect", "start-suspended", ...
[[nodiscard]] std::string_view ToString(PlanStep::Kind kind);
/// "create robot/arm (SimulatedArm of simulated_arm)", "connect a/b/C -> d/e/F".
[[nodiscard]] std::string ToString(const PlanStep& step);

/// The steps that bring a running system to the state of a file, in their order. According to the
/// catalogue, each should succeed. First, components that must not run or must be created again are
/// stopped or suspended, clients before their servers. Then connections and components are removed,
/// processes started, components created and connected, and finally started, servers before their
/// clients.
struct Plan {
  std::vector<PlanStep> steps;
  std::vector<std::string> obstacles;  ///< a sentence for each goal that no step can reach
  /// Further information, a sentence each: that a process runs an outdated plug-in whose file has
  /// changed.
  std::vector<std::string> notes{};
  std::size_t untouched = 0;  ///< number of parts that are already as in the file
  /// The error code for the obstacles: kIncompatible if all are interfaces that do not fit,
  /// kNotFound if all are missing ends or results of these.
  ErrorCode refusal = ErrorCode::kFailed;

  /// True if a step stops or disconnects a working part.
  [[nodiscard]] bool TakesAway() const;
};

/// The plan after which the processes in the file are exactly as in the file; components that are
/// not in the file are removed from them. Other processes are not changed. A component is not
/// started if a connection in the file cannot be made, nor, with a strict file, if a connection
/// that it needs is not in the file. The latter is checked here for existing components, and by the
/// process for new ones.
[[nodiscard]] Plan MakePlan(const Catalogue& catalogue, const SystemFile& wanted);

/// The plan, followed by steps that end the processes started by `births`, if their instances still
/// exist or may be restarted by the GCM. A process that was started again meanwhile may belong to
/// another user, and stays.
[[nodiscard]] Plan WithEnds(Plan plan, const Catalogue& catalogue,
                            const std::vector<PlanStep>& births);

}  // namespace tendon
