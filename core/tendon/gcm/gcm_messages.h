#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/supervisor/restart_policy.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>
#include <tendon/process/log/log_messages.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// The messages between a GCM and its viewers. Messages to LCMs are in
/// process/membership_messages.h and process/lifecycle/lifecycle_messages.h. Each struct is the
/// body of a frame.
namespace tendon {

/// The effect of a connect request if the required interface is already connected.
enum class WhenConnected {
  kRefuse,   ///< sent as kConnect
  kReplace,  ///< sent as kReplace
};

/// The orders to a GCM for a process on its own host.
enum class ProcessVerb : std::int32_t {
  kStart,  ///< starts an `lcm` without components, and waits until it has joined
  kKill,   ///< terminates the process, kills it if necessary, and waits for its end
};

template <>
inline constexpr auto kPayload<ProcessVerb> = DescribeEnum("tendon.ProcessVerb",
                                                           Enumerator{"start", ProcessVerb::kStart},
                                                           Enumerator{"kill", ProcessVerb::kKill});

/// "start", "kill"
[[nodiscard]] constexpr std::string_view ToString(ProcessVerb verb) noexcept {
  return NameOf(verb);
}

}  // namespace tendon

namespace tendon::message {

// Requests from a viewer. A viewer also sends kRenew every second, to check that the GCM is alive.
inline constexpr auto kWatch = static_cast<MessageType>(0x310);  // None -> CatalogueSnapshot
// ConnectionEnds -> ConnectionDescription
inline constexpr auto kConnect = static_cast<MessageType>(0x311);
inline constexpr auto kDisconnect = static_cast<MessageType>(0x312);  // ConnectionEnds -> None
inline constexpr auto kUndo = static_cast<MessageType>(0x313);     // StepSelection -> HistoryEntry
inline constexpr auto kHistory = static_cast<MessageType>(0x314);  // None -> History
inline constexpr auto kForget = static_cast<MessageType>(0x315);   // ForgetProcess -> None
// ConnectionEnds -> ConnectionDescription
inline constexpr auto kReplace = static_cast<MessageType>(0x316);
inline constexpr auto kHealth = static_cast<MessageType>(0x31a);       // None -> SystemHealth
inline constexpr auto kProcess = static_cast<MessageType>(0x31b);      // ProcessOrder -> None
inline constexpr auto kGetChildren = static_cast<MessageType>(0x31d);  // None -> Children
inline constexpr auto kPlanLock = static_cast<MessageType>(0x31e);     // PlanLock -> None
inline constexpr auto kSkipStep = static_cast<MessageType>(0x31f);  // StepSelection -> HistoryEntry
inline constexpr auto kWatchLog = static_cast<MessageType>(0x342);  // WatchLog -> WatchLogReply
// Sent by the GCM, in addition to the messages of process/log/log_messages.h.
inline constexpr auto kChanges = static_cast<MessageType>(0x320);  // notice to a viewer: Changes

/// The catalogue, as changes that must be applied to the empty catalogue Catalogue::At(base).
struct CatalogueSnapshot {
  std::uint64_t gcm_instance = 0;
  std::uint64_t base = 0;
  std::vector<CatalogueChange> changes;
};

/// The next changes of the catalogue. If they do not follow the viewer's revision, the viewer was
/// too slow and must send kWatch again.
struct Changes {
  std::vector<CatalogueChange> changes;
};

/// Asks for the log records of all processes: first the records that the GCM has kept, then each
/// new record.
struct WatchLog {
  /// Instance of the GCM from which the viewer's records came; 0 if the viewer has no records.
  std::uint64_t gcm_instance = 0;
  std::uint64_t after = 0;  ///< number of the first record that the viewer needs
};

/// The reply to WatchLog. The records follow as LogRecords.
struct WatchLogReply {
  std::uint64_t gcm_instance = 0;
  std::uint64_t begin = 0;  ///< number of the first record that follows
  std::uint64_t end = 0;    ///< number of the GCM's next new record
};

/// The resources that a member uses, from its last report.
struct ProcessHealth {
  std::string process;
  std::uint64_t instance = 0;
  double cpu = -1.0;         ///< number of busy cores; negative until the second report
  std::uint64_t memory = 0;  ///< resident bytes
  /// The steady clock of the process minus the GCM's clock, and the largest possible error of this
  /// offset. The error is negative while the offset is not known.
  std::chrono::nanoseconds clock_offset{0};
  std::chrono::nanoseconds clock_uncertainty{-1};
  std::chrono::nanoseconds age{0};  ///< time since the last report; members report every second
};

/// The health of all members that have reported. Processes that are not present are not included.
struct SystemHealth {
  std::vector<ProcessHealth> processes;  ///< by name
};

/// Asks the GCM to remove a process that is lost or has left.
struct ForgetProcess {
  std::string process;
};

/// An order to start a process, or to end a process that the GCM has started.
struct ProcessOrder {
  ProcessVerb verb = ProcessVerb::kStart;
  std::string process;
  RestartPolicy restart = RestartPolicy::kNever;  ///< used only with kStart
  /// The time limit; if 0, the GCM chooses it. kStart ends a process that has not joined within
  /// this time. kKill kills a process that has not ended within this time.
  std::chrono::nanoseconds timeout{0};
};

/// The change that a lifecycle step made, and the state before the step.
struct LifecycleStep {
  std::string process;
  std::string component;  ///< empty for the start of a process
  std::string class_name;
  std::string library;
  std::string configuration;  ///< "create", "configure": the new configuration
  /// For "configure" and "remove", the old configuration. For "stop", the followers that were
  /// stopped with the component; see lifecycle/followers.h.
  std::string former;
  std::string thread;                                   ///< "remove": as in LifecycleOrder
  std::string leader;                                   ///< "remove": as in LifecycleOrder
  ComponentState state = ComponentState::kConstructed;  ///< state before the step
  std::vector<ConnectionEnds> connections;              ///< "remove": the component's connections

  bool operator==(const LifecycleStep&) const = default;
};

/// A process that the GCM has started. Only these can be ended or restarted by the GCM.
struct Child {
  std::string process;
  RestartPolicy restart = RestartPolicy::kNever;
};

/// The reply to kGetChildren. The catalogue does not contain this information.
struct Children {
  std::vector<Child> processes;  ///< by name
};

/// The step to undo or to skip.
struct StepSelection {
  /// The number of the step; 0 for the newest step. The request is refused if another step is the
  /// newest.
  std::uint64_t id = 0;
  /// The time limit for each order that undoes a part of the step; if 0, the GCM chooses it.
  std::chrono::nanoseconds timeout{0};
};

/// Takes or releases the lock for the execution of plans. Sent before the first and after the last
/// step of a plan. Without the lock, two plans that are executed at the same time could undo each
/// other's steps.
struct PlanLock {
  /// True takes the lock, and is refused while another viewer has it. False releases the lock.
  bool is_wanted = true;
};

/// One step of the history, which can be undone.
struct HistoryEntry {
  std::uint64_t id = 0;
  std::string verb;  ///< "connect", "disconnect", "replace", or the verb of an order
  ConnectionEnds ends;
  InterfaceName former;  ///< "replace": the former provided interface
  /// The lifecycle step. Its `process` is empty if this is a step of a connection.
  LifecycleStep lifecycle;
  std::string who;        ///< the program that made the request: "gcm connect", "gcm-gui"
  std::int64_t when = 0;  ///< ns since 1970
  /// The instance of the process that made the change. For a connection, this is the process of the
  /// required side. If the process has been restarted, the step cannot be undone.
  std::uint64_t instance = 0;
  bool is_unknown = false;  ///< true if the outcome of the step is unknown
  bool undone = false;
  bool passed_over = false;  ///< true if a user has skipped the step

  bool operator==(const HistoryEntry&) const = default;
};

/// The recorded changes that people and programs have requested from the GCM.
struct History {
  std::vector<HistoryEntry> entries;  ///< oldest first
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::CatalogueSnapshot> = tendon::Describe(
    "tendon.Snapshot",
    tendon::Field{"gcm_instance", &tendon::message::CatalogueSnapshot::gcm_instance},
    tendon::Field{"base", &tendon::message::CatalogueSnapshot::base},
    tendon::Field{"changes", &tendon::message::CatalogueSnapshot::changes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Changes> = tendon::Describe(
    "tendon.Changes", tendon::Field{"changes", &tendon::message::Changes::changes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::WatchLog> = tendon::Describe(
    "tendon.WatchLog", tendon::Field{"gcm_instance", &tendon::message::WatchLog::gcm_instance},
    tendon::Field{"after", &tendon::message::WatchLog::after});

template <>
inline constexpr auto tendon::kPayload<tendon::message::WatchLogReply> =
    tendon::Describe("tendon.WatchLogReply",
                     tendon::Field{"gcm_instance", &tendon::message::WatchLogReply::gcm_instance},
                     tendon::Field{"begin", &tendon::message::WatchLogReply::begin},
                     tendon::Field{"end", &tendon::message::WatchLogReply::end});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ProcessHealth> = tendon::Describe(
    "tendon.ProcessHealth", tendon::Field{"process", &tendon::message::ProcessHealth::process},
    tendon::Field{"instance", &tendon::message::ProcessHealth::instance},
    tendon::Field{"cpu", &tendon::message::ProcessHealth::cpu},
    tendon::Field{"memory", &tendon::message::ProcessHealth::memory, "B"},
    tendon::Field{"clock_offset", &tendon::message::ProcessHealth::clock_offset},
    tendon::Field{"clock_uncertainty", &tendon::message::ProcessHealth::clock_uncertainty},
    tendon::Field{"age", &tendon::message::ProcessHealth::age});

template <>
inline constexpr auto tendon::kPayload<tendon::message::SystemHealth> = tendon::Describe(
    "tendon.SystemHealth", tendon::Field{"processes", &tendon::message::SystemHealth::processes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ForgetProcess> = tendon::Describe(
    "tendon.ForgetProcess", tendon::Field{"process", &tendon::message::ForgetProcess::process});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ProcessOrder> = tendon::Describe(
    "tendon.ProcessOrder", tendon::Field{"verb", &tendon::message::ProcessOrder::verb},
    tendon::Field{"process", &tendon::message::ProcessOrder::process},
    tendon::Field{"restart", &tendon::message::ProcessOrder::restart},
    tendon::Field{"timeout", &tendon::message::ProcessOrder::timeout});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Child> =
    tendon::Describe("tendon.Child", tendon::Field{"process", &tendon::message::Child::process},
                     tendon::Field{"restart", &tendon::message::Child::restart});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Children> = tendon::Describe(
    "tendon.Children", tendon::Field{"processes", &tendon::message::Children::processes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::StepSelection> = tendon::Describe(
    "tendon.StepSelection", tendon::Field{"id", &tendon::message::StepSelection::id},
    tendon::Field{"timeout", &tendon::message::StepSelection::timeout});

template <>
inline constexpr auto tendon::kPayload<tendon::message::PlanLock> = tendon::Describe(
    "tendon.PlanLock", tendon::Field{"is_wanted", &tendon::message::PlanLock::is_wanted});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LifecycleStep> = tendon::Describe(
    "tendon.LifeStep", tendon::Field{"process", &tendon::message::LifecycleStep::process},
    tendon::Field{"component", &tendon::message::LifecycleStep::component},
    tendon::Field{"class_name", &tendon::message::LifecycleStep::class_name},
    tendon::Field{"library", &tendon::message::LifecycleStep::library},
    tendon::Field{"configuration", &tendon::message::LifecycleStep::configuration},
    tendon::Field{"former", &tendon::message::LifecycleStep::former},
    tendon::Field{"thread", &tendon::message::LifecycleStep::thread},
    tendon::Field{"leader", &tendon::message::LifecycleStep::leader},
    tendon::Field{"state", &tendon::message::LifecycleStep::state},
    tendon::Field{"connections", &tendon::message::LifecycleStep::connections});

template <>
inline constexpr auto tendon::kPayload<tendon::message::HistoryEntry> =
    tendon::Describe("tendon.HistoryEntry", tendon::Field{"id", &tendon::message::HistoryEntry::id},
                     tendon::Field{"verb", &tendon::message::HistoryEntry::verb},
                     tendon::Field{"ends", &tendon::message::HistoryEntry::ends},
                     tendon::Field{"former", &tendon::message::HistoryEntry::former},
                     tendon::Field{"life", &tendon::message::HistoryEntry::lifecycle},
                     tendon::Field{"who", &tendon::message::HistoryEntry::who},
                     tendon::Field{"when", &tendon::message::HistoryEntry::when, "ns"},
                     tendon::Field{"instance", &tendon::message::HistoryEntry::instance},
                     tendon::Field{"is_unknown", &tendon::message::HistoryEntry::is_unknown},
                     tendon::Field{"undone", &tendon::message::HistoryEntry::undone},
                     tendon::Field{"passed_over", &tendon::message::HistoryEntry::passed_over});

template <>
inline constexpr auto tendon::kPayload<tendon::message::History> = tendon::Describe(
    "tendon.History", tendon::Field{"entries", &tendon::message::History::entries});
