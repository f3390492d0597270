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
    kStartProcess,  ///< starts a process without components on the GCM's host
    kConfigure,     ///< creates a stopped component again with another configuration; keeps its
                    ///< connections
    kCreate,
    kConnect,
    kReplace,  ///< replaces the connection of a required interface
    kStart,
    kStartSuspended,  ///< starts a component, then suspends it
    kEndProcess,      ///< ends a process that the GCM has started
  };

  Kind kind = Kind::kConnect;
  message::ConnectionEnds ends{};  ///< for connections: the two interfaces
  /// For steps of components, the process of the component. For steps of processes, the process
  /// itself.
  std::string process{};
  /// The instance that the process of the step had when the plan was made; 0 if the plan itself
  /// starts the process.
  std::uint64_t instance = 0;
  /// For steps of components. For kCreate, the component as the file describes it.
  SystemFile::Component component{};
  std::vector<message::ConnectionEnds>
      needs{};  ///< to start: connections that must be active first
  /// To start a process, its restart policy. To end a process, its former policy, with which it can
  /// be started again.
  RestartPolicy restart = RestartPolicy::kNever;
  bool is_strict = false;   ///< to start: refuse if a needed connection is missing
  bool takes_away = false;  ///< stops or disconnects a working part
  Fingerprint based_on{};   ///< to configure: BaseOf() of the present configuration

  bool operator==(const PlanStep&) const = default;
};

/// "create", "connect", "start-suspended", ...
[[nodiscard]] std::string_view ToString(PlanStep::Kind kind);
/// "create robot/arm (SimulatedArm of simulated_arm)", "connect a/b/C -> d/e/F".
[[nodiscard]] std::string ToString(const PlanStep& step);

/// The steps that make a running system match a file, in the order of execution. According to the
/// catalogue, each step should succeed. The order is:
/// 1. Components that must not run or must be created again are stopped or suspended, clients
///    before their servers.
/// 2. Connections and components are removed.
/// 3. Processes are started, and components are created and connected.
/// 4. Components are started, servers before their clients.
struct Plan {
  std::vector<PlanStep> steps;
  /// A sentence for each part of the file that no step can produce.
  std::vector<std::string> obstacles;
  /// Sentences with further information, for example that a process runs an old version of a
  /// plug-in whose file has changed.
  std::vector<std::string> notes{};
  std::size_t untouched = 0;  ///< number of parts that already match the file
  /// The error code for the obstacles. It is the code of the refused connections if all obstacles
  /// result from connections that were refused with the same code, for example kIncompatible or
  /// kNotFound. Otherwise it is kFailed.
  ErrorCode refusal = ErrorCode::kFailed;

  /// True if a step stops or disconnects a working part.
  [[nodiscard]] bool TakesAway() const;
};

/// Returns the plan that makes the processes in the file exactly as the file describes them. The
/// plan removes components of these processes that are not in the file. It does not change other
/// processes.
///
/// A component is not started if one of its connections in the file cannot be made. If the file is
/// strict, a component is also not started if it needs a connection that is not in the file.
/// MakePlan() checks this for existing components. For new components, the process checks it at the
/// start.
[[nodiscard]] Plan MakePlan(const Catalogue& catalogue, const SystemFile& wanted);

/// Returns the plan, followed by steps that end the processes that the steps `births` have started.
/// Ends only the same instances, if they still run or the GCM may restart them. A process that was
/// started again may belong to another user, so it is not ended.
[[nodiscard]] Plan WithEnds(Plan plan, const Catalogue& catalogue,
                            const std::vector<PlanStep>& births);

}  // namespace tendon
