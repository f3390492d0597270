#pragma once

#include <tendon/middleware/frame.h>
#include <tendon/process/process_description.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

/// The messages between a GCM and the LCMs that join it. Each struct is the body of a frame;
/// requests are answered, notices are not.
namespace tendon::message {

// From an LCM.
inline constexpr auto kJoin = static_cast<MessageType>(0x300);    // request: Join -> JoinReply
inline constexpr auto kReport = static_cast<MessageType>(0x301);  // notice: Report
inline constexpr auto kRenew = static_cast<MessageType>(0x302);   // request: None -> None
inline constexpr auto kLeave = static_cast<MessageType>(0x303);   // request: None -> None
inline constexpr auto kReportHealth =
    static_cast<MessageType>(0x304);  // request: Health -> GcmClock
// From the GCM, on the channel on which the process joined. Request: ConnectionPlan ->
// ConnectionDescription. The LCM reports the connection before it answers.
inline constexpr auto kMakeConnection = static_cast<MessageType>(0x321);
// Request: ConnectionEnds -> None. The LCM reports the end of the connection before it answers.
inline constexpr auto kBreakConnection = static_cast<MessageType>(0x322);
inline constexpr auto kPeers = static_cast<MessageType>(0x323);  // notice: PeerList

/// The description of a joining process, from which the GCM rebuilds its state. A process continues
/// its membership if it joins with the same instance and the last session in its Hello. This works
/// even if the GCM has not noticed yet that the old link is broken.
struct Join {
  ProcessDescription process;  ///< the GCM sets `state`, `reason` and `since`
  std::vector<ComponentDescription> components;
  std::vector<ConnectionDescription> connections;
};

/// The GCM's reply. A membership lasts while its channel is open and kRenew arrives every 250 ms.
/// If a renewal is refused with kDenied, the membership has ended, and the process must join again.
struct JoinReply {
  std::uint64_t gcm_instance = 0;
  std::uint64_t session = 0;                  ///< token of this membership
  std::vector<ProcessDescription> processes;  ///< all present processes, including this one
};

/// The changes in a process since it joined or since its last report. Each change is a
/// CatalogueChange with revision 0. In the description of the process itself, only address, host,
/// pid and plug-ins can change.
struct Report {
  std::vector<CatalogueChange> changes;
};

/// The resources that a process uses, sent every second. Not part of the catalogue.
struct Health {
  std::int64_t cpu_time = 0;  ///< ns of all threads since the start of the process
  std::uint64_t memory = 0;   ///< resident bytes
  std::int64_t time = 0;      ///< time of the measurement, ns on the steady clock of the process
  /// The clock of the process minus the GCM's clock, estimated from earlier replies.
  std::chrono::nanoseconds clock_offset{0};
  /// The largest possible error of clock_offset; negative before the first estimate.
  std::chrono::nanoseconds clock_uncertainty{-1};
};

/// The GCM's steady clock at the time of its reply.
struct GcmClock {
  std::int64_t time = 0;  ///< ns
};

/// The two ends of a connection; `provided` is empty for a disconnect.
struct ConnectionEnds {
  InterfaceName required;
  InterfaceName provided;

  bool operator==(const ConnectionEnds&) const = default;
};

/// The order to the LCM of the required side to make a connection. It has the two ends, and the
/// address of the provider's process. If the provider's process does not exist yet, the address is
/// empty, and the connection is pending.
struct ConnectionPlan {
  ConnectionEnds ends;
  std::string address;
  std::uint64_t instance = 0;
};

/// All present processes and their addresses. Sent at each change, so that processes make pending
/// and broken connections again.
struct PeerList {
  std::vector<ProcessDescription> processes;
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::Join> =
    tendon::Describe("tendon.Join", tendon::Field{"process", &tendon::message::Join::process},
                     tendon::Field{"components", &tendon::message::Join::components},
                     tendon::Field{"connections", &tendon::message::Join::connections});

template <>
inline constexpr auto tendon::kPayload<tendon::message::JoinReply> = tendon::Describe(
    "tendon.JoinReply", tendon::Field{"gcm_instance", &tendon::message::JoinReply::gcm_instance},
    tendon::Field{"session", &tendon::message::JoinReply::session},
    tendon::Field{"processes", &tendon::message::JoinReply::processes});

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
inline constexpr auto tendon::kPayload<tendon::message::ConnectionEnds> = tendon::Describe(
    "tendon.ConnectionEnds", tendon::Field{"required", &tendon::message::ConnectionEnds::required},
    tendon::Field{"provided", &tendon::message::ConnectionEnds::provided});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ConnectionPlan> = tendon::Describe(
    "tendon.ConnectionPlan", tendon::Field{"ends", &tendon::message::ConnectionPlan::ends},
    tendon::Field{"address", &tendon::message::ConnectionPlan::address},
    tendon::Field{"instance", &tendon::message::ConnectionPlan::instance});

template <>
inline constexpr auto tendon::kPayload<tendon::message::PeerList> = tendon::Describe(
    "tendon.PeerList", tendon::Field{"processes", &tendon::message::PeerList::processes});
