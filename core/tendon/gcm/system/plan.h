#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/system_file.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/membership_messages.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// One thing to be done to a running system.
struct PlanStep {
  enum class Kind {
    kStop,
    kSuspend,
    kDisconnect,
    kRemove,
    kStartProcess,  ///< without components; the GCM does, on its own host
    kConfigure,     ///< makes a component at rest anew; its connections stay
    kCreate,
    kConnect,
    kReplace,  ///< what a required interface is connected to
    kStart,
    kStartSuspended,  ///< by way of active
    kEndProcess,      ///< one that the GCM has started
  };

  Kind kind = Kind::kConnect;
  message::Wire wire{};                ///< of connections: the ends
  std::string process{};               ///< of components: where; to start it: which
  std::uint64_t instance = 0;          ///< of the process that carries it out, when it was planned;
                                       ///< 0: which is started by the plan
  SystemFile::Component component{};   ///< of components: which; to make one: as the file has it
  std::vector<message::Wire> needs{};  ///< to start: what must be connected before
  /// To start a process: how it is to be held; to end one: how it was, so that it can be started
  /// again likewise.
  RestartPolicy restart = RestartPolicy::kNever;
  bool is_strict = false;   ///< to start: refused where it lacks a connection that it needs
  bool takes_away = false;  ///< what runs or is connected now is not so afterwards
  Fingerprint based_on{};   ///< to configure: BaseOf() what it is told now

  bool operator==(const PlanStep&) const = default;
};

/// "create", "connect", "start-suspended", ...
[[nodiscard]] std::string_view ToString(PlanStep::Kind kind);
/// "create robot/arm (SimulatedArm of simulated_arm)", "connect a/b/C -> d/e/F".
[[nodiscard]] std::string ToString(const PlanStep& step);

/// How a running system becomes that of a file: steps in the order in which they are to be made,
/// each of which the catalogue lets expect to succeed. What is to rest, or to be made anew, rests
/// first, clients before their servers. Then connections and components go, processes are started,
/// components are made and connected, and in the end started, servers before their clients.
struct Plan {
  std::vector<PlanStep> steps;
  std::vector<std::string> obstacles;  ///< a sentence for each thing that no step can bring about
  /// What else is to be known, a sentence each: that a process runs the code of a plug-in whose
  /// file was written again since.
  std::vector<std::string> notes{};
  std::size_t untouched = 0;  ///< things that are as they should be
  /// Of the obstacles: kIncompatible where all are ends that do not fit, kNotFound where all are
  /// ends that are not there, or what follows from those.
  ErrorCode refusal = ErrorCode::kFailed;

  /// Whether one of the steps does.
  [[nodiscard]] bool TakesAway() const;
};

/// In the processes that the file names, all becomes as it says: what it does not have there is
/// removed. Other processes are left alone. A component that lacks a connection of the file, since
/// that cannot be made, is not started; nor, where the file is strict, is one that needs a
/// connection which the file does not have: seen here of components that are there, and by the
/// process of those that are made.
[[nodiscard]] Plan MakePlan(const Catalog& catalog, const SystemFile& wanted);

/// As the plan, and in the end the processes which `births` have started are ended: those of the
/// births' instances that are there still, or that the GCM may be about to start again. One that
/// was started again since may be another's, and is left.
[[nodiscard]] Plan WithEnds(Plan plan, const Catalog& catalog, const std::vector<PlanStep>& births);

}  // namespace tendon
