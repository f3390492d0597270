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
    kStartProcess,  ///< without components; the GCM does it on its own host
    kConfigure,     ///< creates a stopped component anew; its connections stay
    kCreate,
    kConnect,
    kReplace,  ///< replaces the connection of a required interface
    kStart,
    kStartSuspended,  ///< starts, then suspends
    kEndProcess,      ///< one that the GCM has started
  };

  Kind kind = Kind::kConnect;
  message::Wire wire{};                ///< of connections: the ends
  std::string process{};               ///< of components: their process; to start: its name
  std::uint64_t instance = 0;          ///< of the executing process at the time of planning;
                                       ///< 0: one that the plan starts
  SystemFile::Component component{};   ///< of components; to create one: as in the file
  std::vector<message::Wire> needs{};  ///< to start: must be connected before
  /// To start a process: its policy; to end one: the policy it had, so that an undo can start it
  /// again with that.
  RestartPolicy restart = RestartPolicy::kNever;
  bool is_strict = false;   ///< to start: refused without a connection that it needs
  bool takes_away = false;  ///< stops or disconnects something that works now
  Fingerprint based_on{};   ///< to configure: BaseOf() the present configuration

  bool operator==(const PlanStep&) const = default;
};

/// "create", "connect", "start-suspended", ...
[[nodiscard]] std::string_view ToString(PlanStep::Kind kind);
/// "create robot/arm (SimulatedArm of simulated_arm)", "connect a/b/C -> d/e/F".
[[nodiscard]] std::string ToString(const PlanStep& step);

/// How a running system becomes that of a file: steps in their order, each of which should succeed
/// according to the catalogue. First, components that are to rest or to be created anew are stopped
/// or suspended, clients before their servers. Then connections and components are removed,
/// processes started, components created and connected, and finally started, servers before their
/// clients.
struct Plan {
  std::vector<PlanStep> steps;
  std::vector<std::string> obstacles;  ///< a sentence for each thing that no step can achieve
  /// Further information, a sentence each: that a process runs an outdated plug-in whose file has
  /// changed.
  std::vector<std::string> notes{};
  std::size_t untouched = 0;  ///< things that are already as wanted
  /// The error code for the obstacles: kIncompatible if all are ends that do not fit, kNotFound if
  /// all are missing ends or follow from those.
  ErrorCode refusal = ErrorCode::kFailed;

  /// Whether any step takes something away.
  [[nodiscard]] bool TakesAway() const;
};

/// Makes the processes in the file exactly as it says, and removes what it does not contain there.
/// Leaves other processes alone. Does not start a component if a connection in the file cannot be
/// made; nor, if the file is strict, if it needs a connection that the file lacks. That is checked
/// here for existing components, and by the process for those that are created.
[[nodiscard]] Plan MakePlan(const Catalogue& catalogue, const SystemFile& wanted);

/// The plan, followed by steps that end the processes which `births` have started: those whose
/// instances are still there, or may be restarted by the GCM. A process that was started again
/// since may belong to another user, and stays.
[[nodiscard]] Plan WithEnds(Plan plan, const Catalogue& catalogue,
                            const std::vector<PlanStep>& births);

}  // namespace tendon
