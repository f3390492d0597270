#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/supervisor/restart_policy.h>
#include <tendon/process/life/messages.h>
#include <tendon/process/log/messages.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// What travels between a GCM and the viewers that watch it; what it says to LCMs is in
/// process/membership_messages.h, and what it passes on to them in process/life/messages.h. Each
/// struct is the body of a frame.
namespace tendon {

/// What can be asked of a GCM for a process of its own host.
enum class ProcessVerb : std::int32_t {
  kStart,  ///< an `lcm` without components; done once it has joined
  kKill,   ///< asks it to end, and ends it where it does not; done once it is gone
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

// From a viewer; all are requests. A viewer also sends kRenew each second, to see that the GCM
// lives.
inline constexpr auto kWatch = static_cast<MessageType>(0x310);    // None -> Snapshot
inline constexpr auto kConnect = static_cast<MessageType>(0x311);  // Wire -> ConnectionDescription
inline constexpr auto kDisconnect = static_cast<MessageType>(0x312);  // Wire -> None
inline constexpr auto kUndo = static_cast<MessageType>(0x313);        // WhichStep -> HistoryEntry
inline constexpr auto kHistory = static_cast<MessageType>(0x314);     // None -> History
inline constexpr auto kForget = static_cast<MessageType>(0x315);      // Forget -> None
inline constexpr auto kReplace = static_cast<MessageType>(0x316);   // Wire -> ConnectionDescription
inline constexpr auto kHealth = static_cast<MessageType>(0x31a);    // None -> SystemHealth
inline constexpr auto kProcess = static_cast<MessageType>(0x31b);   // ProcessOrder -> None
inline constexpr auto kPlanTurn = static_cast<MessageType>(0x31e);  // PlanTurn -> None
inline constexpr auto kPassOver = static_cast<MessageType>(0x31f);  // WhichStep -> HistoryEntry
inline constexpr auto kWatchLog = static_cast<MessageType>(0x342);  // WatchLog -> LogWatched
// From the GCM, besides process/log/messages.h.
inline constexpr auto kChanges = static_cast<MessageType>(0x320);  // notice to a viewer: Changes

/// The catalogue as changes on an empty one (Catalog::At(base)).
struct Snapshot {
  std::uint64_t gcm_instance = 0;
  std::uint64_t base = 0;
  std::vector<CatalogChange> changes;
};

/// The next changes. Where they do not follow what the viewer has, it read too slowly: it asks for
/// kWatch again.
struct Changes {
  std::vector<CatalogChange> changes;
};

/// The records of all processes from now on, and first those that the GCM has kept.
struct WatchLog {
  std::uint64_t gcm_instance = 0;  ///< of the GCM whose records the viewer has, or 0
  std::uint64_t after = 0;         ///< it has all of them before this one
};

/// The answer to WatchLog; the records follow, as LogRecords.
struct LogWatched {
  std::uint64_t gcm_instance = 0;
  std::uint64_t begin = 0;  ///< number of the first
  std::uint64_t end = 0;    ///< of the one that the GCM will have next
};

/// How a member does, as it has told last.
struct ProcessHealth {
  std::string process;
  std::uint64_t instance = 0;
  double cpu = -1.0;         ///< cores that it kept busy; below 0 until it has told twice
  std::uint64_t memory = 0;  ///< bytes that are resident
  /// How far its steady clock is ahead of the GCM's, and how far that may be off: below 0 where
  /// nothing is known yet.
  std::chrono::nanoseconds clock_offset{0};
  std::chrono::nanoseconds clock_uncertainty{-1};
  std::chrono::nanoseconds age{0};  ///< since it told this; members tell each second
};

/// The members that have told; tombstones are none.
struct SystemHealth {
  std::vector<ProcessHealth> processes;  ///< by name
};

/// A tombstone to be removed.
struct Forget {
  std::string process;
};

/// One verb, for a process that the GCM itself starts, or has started.
struct ProcessOrder {
  ProcessVerb verb = ProcessVerb::kStart;
  std::string process;
  RestartPolicy restart = RestartPolicy::kNever;  ///< start
  /// Until one that has not joined is stopped again, and one that has not ended is killed; 0: as
  /// long as the GCM finds right.
  std::chrono::nanoseconds patience{0};
};

/// What a step in the life of a component was about, and what there was before it.
struct LifeStep {
  std::string process;
  std::string component;  ///< empty: of the process itself, which was started
  std::string class_name;
  std::string library;
  std::string configuration;  ///< "create", "configure": that it has now
  /// "configure", "remove": that it had; "stop": who ended with it, as followers.h has it.
  std::string former;
  std::string thread;                                   ///< "remove": as LifeOrder has it
  std::string leader;                                   ///< "remove": likewise
  ComponentState state = ComponentState::kConstructed;  ///< before
  std::vector<Wire> connections;                        ///< "remove": of this component

  bool operator==(const LifeStep&) const = default;
};

/// Which step is to be taken back, or passed over.
struct WhichStep {
  std::uint64_t id = 0;  ///< refused where it is not the newest any more; 0: whichever that is
  std::chrono::nanoseconds patience{0};  ///< for each of its orders; 0: as the GCM finds right
};

/// Before the first step of a plan, and after the last: of two that made plans for the same system
/// at once, each would undo the other's.
struct PlanTurn {
  bool is_wanted = true;  ///< refused while another viewer has it; false: it is given back
};

/// One step that was made, and can be unmade.
struct HistoryEntry {
  std::uint64_t id = 0;
  std::string verb;  ///< "connect", "disconnect", "replace", or that of an order
  Wire wire;
  InterfaceName former;   ///< "replace": what the required interface was connected to
  LifeStep life;          ///< of an order for a life, else without a process
  std::string who;        ///< the program that asked: "gcm connect", "gcm-gui"
  std::int64_t when = 0;  ///< ns since 1970
  /// Of the process of the required side, which had made it: one that was started again has
  /// nothing of it to undo.
  std::uint64_t instance = 0;
  bool is_unknown = false;  ///< it was begun, and nobody has heard whether it was done
  bool undone = false;
  bool passed_over = false;  ///< it could not be undone any more, and somebody has said so

  bool operator==(const HistoryEntry&) const = default;
};

/// What people and programs have asked for.
struct History {
  std::vector<HistoryEntry> entries;  ///< oldest first
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::Snapshot> = tendon::Describe(
    "tendon.Snapshot", tendon::Field{"gcm_instance", &tendon::message::Snapshot::gcm_instance},
    tendon::Field{"base", &tendon::message::Snapshot::base},
    tendon::Field{"changes", &tendon::message::Snapshot::changes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Changes> = tendon::Describe(
    "tendon.Changes", tendon::Field{"changes", &tendon::message::Changes::changes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::WatchLog> = tendon::Describe(
    "tendon.WatchLog", tendon::Field{"gcm_instance", &tendon::message::WatchLog::gcm_instance},
    tendon::Field{"after", &tendon::message::WatchLog::after});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LogWatched> = tendon::Describe(
    "tendon.LogWatched", tendon::Field{"gcm_instance", &tendon::message::LogWatched::gcm_instance},
    tendon::Field{"begin", &tendon::message::LogWatched::begin},
    tendon::Field{"end", &tendon::message::LogWatched::end});

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
inline constexpr auto tendon::kPayload<tendon::message::Forget> =
    tendon::Describe("tendon.Forget", tendon::Field{"process", &tendon::message::Forget::process});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ProcessOrder> = tendon::Describe(
    "tendon.ProcessOrder", tendon::Field{"verb", &tendon::message::ProcessOrder::verb},
    tendon::Field{"process", &tendon::message::ProcessOrder::process},
    tendon::Field{"restart", &tendon::message::ProcessOrder::restart},
    tendon::Field{"patience", &tendon::message::ProcessOrder::patience});

template <>
inline constexpr auto tendon::kPayload<tendon::message::WhichStep> =
    tendon::Describe("tendon.WhichStep", tendon::Field{"id", &tendon::message::WhichStep::id},
                     tendon::Field{"patience", &tendon::message::WhichStep::patience});

template <>
inline constexpr auto tendon::kPayload<tendon::message::PlanTurn> = tendon::Describe(
    "tendon.PlanTurn", tendon::Field{"is_wanted", &tendon::message::PlanTurn::is_wanted});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LifeStep> = tendon::Describe(
    "tendon.LifeStep", tendon::Field{"process", &tendon::message::LifeStep::process},
    tendon::Field{"component", &tendon::message::LifeStep::component},
    tendon::Field{"class_name", &tendon::message::LifeStep::class_name},
    tendon::Field{"library", &tendon::message::LifeStep::library},
    tendon::Field{"configuration", &tendon::message::LifeStep::configuration},
    tendon::Field{"former", &tendon::message::LifeStep::former},
    tendon::Field{"thread", &tendon::message::LifeStep::thread},
    tendon::Field{"leader", &tendon::message::LifeStep::leader},
    tendon::Field{"state", &tendon::message::LifeStep::state},
    tendon::Field{"connections", &tendon::message::LifeStep::connections});

template <>
inline constexpr auto tendon::kPayload<tendon::message::HistoryEntry> =
    tendon::Describe("tendon.HistoryEntry", tendon::Field{"id", &tendon::message::HistoryEntry::id},
                     tendon::Field{"verb", &tendon::message::HistoryEntry::verb},
                     tendon::Field{"wire", &tendon::message::HistoryEntry::wire},
                     tendon::Field{"former", &tendon::message::HistoryEntry::former},
                     tendon::Field{"life", &tendon::message::HistoryEntry::life},
                     tendon::Field{"who", &tendon::message::HistoryEntry::who},
                     tendon::Field{"when", &tendon::message::HistoryEntry::when, "ns"},
                     tendon::Field{"instance", &tendon::message::HistoryEntry::instance},
                     tendon::Field{"is_unknown", &tendon::message::HistoryEntry::is_unknown},
                     tendon::Field{"undone", &tendon::message::HistoryEntry::undone},
                     tendon::Field{"passed_over", &tendon::message::HistoryEntry::passed_over});

template <>
inline constexpr auto tendon::kPayload<tendon::message::History> = tendon::Describe(
    "tendon.History", tendon::Field{"entries", &tendon::message::History::entries});
