#pragma once

#include <tendon/middleware/frame.h>
#include <tendon/process/description.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// What travels between a GCM and the LCMs that join it. Each struct is the body of a frame;
/// requests are answered, notices are not.
namespace tendon::message {

// From an LCM.
inline constexpr auto kJoin = static_cast<MessageType>(0x300);        // request: Join -> Joined
inline constexpr auto kReport = static_cast<MessageType>(0x301);      // notice: Report
inline constexpr auto kRenew = static_cast<MessageType>(0x302);       // request: None -> None
inline constexpr auto kLeave = static_cast<MessageType>(0x303);       // request: None -> None
inline constexpr auto kTellHealth = static_cast<MessageType>(0x304);  // request: Health -> GcmClock
// From the GCM, on the channel that joined.
// request: Wiring -> ConnectionDescription; the LCM reports the connection before it answers
inline constexpr auto kMakeConnection = static_cast<MessageType>(0x321);
// request: Wire -> None; the LCM reports that it is gone before it answers
inline constexpr auto kBreakConnection = static_cast<MessageType>(0x322);
inline constexpr auto kPeers = static_cast<MessageType>(0x323);  // notice: Peers

/// A process introduces itself with all it has: the GCM's state is rebuilt from these. One that
/// joins again with the instance and the session (in its Hello) of its last membership takes that
/// over, even when the GCM has not yet seen the old link break.
struct Join {
  ProcessDescription process;  ///< state, reason and since are the GCM's to say
  std::vector<ComponentDescription> components;
  std::vector<ConnectionDescription> connections;
};

/// The GCM's answer. A membership lasts while its channel stands and kRenew comes each 250 ms; it
/// is over when a renewal is refused with kDenied: join again.
struct Joined {
  std::uint64_t gcm_instance = 0;
  std::uint64_t session = 0;                  ///< token of this membership
  std::vector<ProcessDescription> processes;  ///< that are there, this one among them
};

/// What has changed in a process since it joined or last reported: steps as in CatalogChange, whose
/// revisions are left 0. Of the process itself only address, host, pid and plug-ins can change.
struct Report {
  std::vector<CatalogChange> changes;
};

/// What a process takes of its machine, each second. It is no part of the catalogue.
struct Health {
  std::int64_t cpu_time = 0;  ///< ns, of all threads since the start of the process
  std::uint64_t memory = 0;   ///< bytes that are resident
  std::int64_t time = 0;      ///< ns on the steady clock of the process, when this was so
  /// How far that clock is ahead of the GCM's, as far as earlier answers tell.
  std::chrono::nanoseconds clock_offset{0};
  /// How far that may be off; below 0 where nothing is known yet.
  std::chrono::nanoseconds clock_uncertainty{-1};
};

/// The GCM's steady clock while it answers.
struct GcmClock {
  std::int64_t time = 0;  ///< ns
};

/// Two ends to be connected; `provided` is empty for a disconnect.
struct Wire {
  InterfaceName required;
  InterfaceName provided;

  bool operator==(const Wire&) const = default;
};

/// The order to a required side's LCM: who, and where the provider's process is reached (empty when
/// it is not there yet: the connection will be pending).
struct Wiring {
  Wire wire;
  std::string address;
  std::uint64_t instance = 0;
};

/// All processes that are there, and where; sent at each change of processes, so that pending and
/// broken connections are made again.
struct Peers {
  std::vector<ProcessDescription> processes;
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::Join> =
    tendon::Describe("tendon.Join", tendon::Field{"process", &tendon::message::Join::process},
                     tendon::Field{"components", &tendon::message::Join::components},
                     tendon::Field{"connections", &tendon::message::Join::connections});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Joined> = tendon::Describe(
    "tendon.Joined", tendon::Field{"gcm_instance", &tendon::message::Joined::gcm_instance},
    tendon::Field{"session", &tendon::message::Joined::session},
    tendon::Field{"processes", &tendon::message::Joined::processes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Report> =
    tendon::Describe("tendon.Report", tendon::Field{"changes", &tendon::message::Report::changes});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Health> = tendon::Describe(
    "tendon.Health", tendon::Field{"cpu_time", &tendon::message::Health::cpu_time, "ns"},
    tendon::Field{"memory", &tendon::message::Health::memory, "B"},
    tendon::Field{"time", &tendon::message::Health::time, "ns"},
    tendon::Field{"clock_offset", &tendon::message::Health::clock_offset},
    tendon::Field{"clock_uncertainty", &tendon::message::Health::clock_uncertainty});

template <>
inline constexpr auto tendon::kPayload<tendon::message::GcmClock> = tendon::Describe(
    "tendon.GcmClock", tendon::Field{"time", &tendon::message::GcmClock::time, "ns"});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Wire> =
    tendon::Describe("tendon.Wire", tendon::Field{"required", &tendon::message::Wire::required},
                     tendon::Field{"provided", &tendon::message::Wire::provided});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Wiring> =
    tendon::Describe("tendon.Wiring", tendon::Field{"wire", &tendon::message::Wiring::wire},
                     tendon::Field{"address", &tendon::message::Wiring::address},
                     tendon::Field{"instance", &tendon::message::Wiring::instance});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Peers> = tendon::Describe(
    "tendon.Peers", tendon::Field{"processes", &tendon::message::Peers::processes});
