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
    kConfigure,  ///< creates a stopped component again with another configuration; its connections
                 ///< stay
    kCreate,
    kConnect,
    kReplace,  ///< replaces the connection of a required interface
    kStart,
    kStartSuspended,  ///< starts a component, then suspends it
    kEndProcess,      ///< ends a process that the GCM has started
  };

  Kind kind = Kind::kConnect;
  message::Wire wire{};  ///< for connections: the two interfaces
  /// For steps of components, their process. For steps of processes, the process.
  std::string process{};
  /// The instance of the process that executes the step, at the time of planning; 0 if the plan
  /// itself starts this process.
  std::uint64_t instance = 0;
  /// For steps of components. To create one, the component as in the file.
  SystemFile::Component component{};
  std::vector<message::Wire> needs{};  ///< to start: connections that must be active before
  /// To start a process, its policy. To end a process, its former policy, so that the process can
  /// be started again with this policy.
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

/// The steps that change a running system so that it is as in a file, in the order of execution.
/// According to the catalogue, each step should succeed. First, components that must not run or
/// must be created again are stopped or suspended, clients before their servers. Then connections
/// and components are removed, processes are started, and components are created and connected.
/// Finally components are started, servers before their clients.
struct Plan {
  std::vector<PlanStep> steps;
  /// A sentence for each part of the file that no step can produce.
  std::vector<std::string> obstacles;
  /// Sentences with further information, for example that a process runs an old version of a
  /// plug-in whose file has changed.
  std::vector<std::string> notes{};
  std::size_t untouched = 0;  ///< number of parts that are already as in the file
  /// The error code for the obstacles. If all obstacles are connections that were refused with the
  /// same code, or follow from these, it is this code, for example kIncompatible for interfaces
  /// that do not fit or kNotFound for missing interfaces. Otherwise it is kFailed.
  ErrorCode refusal = ErrorCode::kFailed;

  /// True if a step stops or disconnects a working part.
  [[nodiscard]] bool TakesAway() const;
};

/// Returns the plan that makes the processes in the file exactly as the file describes them.
/// Components of these processes that are not in the file are removed. Other processes are not
/// changed.
///
/// A component is not started if one of its connections in the file cannot be made. If the file is
/// strict, a component is also not started if it needs a connection that is not in the file. For
/// existing components, MakePlan() checks this; for new components, the process checks it at the
/// start.
[[nodiscard]] Plan MakePlan(const Catalogue& catalogue, const SystemFile& wanted);

/// Returns the plan, followed by steps that end the processes that the steps `births` have started.
/// Ends only the same instances, if they still run or the GCM may restart them. If a process was
/// started again meanwhile, it may belong to another user, so it is not ended.
[[nodiscard]] Plan WithEnds(Plan plan, const Catalogue& catalogue,
                            const std::vector<PlanStep>& births);

}  // namespace tendon
