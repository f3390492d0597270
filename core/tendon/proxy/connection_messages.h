#pragma once

#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The messages between the two ends of a connection. The opener is the process of the required
/// interface. Each struct is the body of a frame. Requests are answered, notices are not. Each end
/// issues a number for the connection, and the other end writes this number into the field `handle`
/// of the header. The handle of member i is this number + 1 + i.
namespace tendon::message {

// Sent by the opener.
inline constexpr auto kOpenInterface =
    static_cast<MessageType>(0x100);  // request: OpenInterface -> OpenInterfaceReply
inline constexpr auto kCloseInterface = static_cast<MessageType>(0x101);  // notice: empty
// notice: a CallBatch with calls of functions
inline constexpr auto kCommands = static_cast<MessageType>(0x102);
// request to the handle of a function: the argument -> the result, followed by one byte with a
// Status::Code
inline constexpr auto kRead = static_cast<MessageType>(0x103);
inline constexpr auto kPing = static_cast<MessageType>(0x104);  // request: None -> Pong
// request to the handle of a function: the argument, followed by the caller's timeout (u64, ns) ->
// a reply as for kRead, which is sent after the call was executed or refused
inline constexpr auto kWait = static_cast<MessageType>(0x105);

// Sent by the other end.

// notice: a CallBatch with calls of event handlers
inline constexpr auto kEvents = static_cast<MessageType>(0x110);
// notice: Credit. The reply to an executed kWait also acts as a Credit: all calls that were sent
// before the kWait were executed, too.
inline constexpr auto kCredit = static_cast<MessageType>(0x111);
// notice: Error; the provided interface does not exist any more
inline constexpr auto kInterfaceClosed = static_cast<MessageType>(0x112);
// notice to a required interface without functions: like kEvents, but each value has the time of
// its event (AddTimed())
inline constexpr auto kTimedEvents = static_cast<MessageType>(0x113);

// Sent by both ends.
inline constexpr auto kEventsLost = static_cast<MessageType>(0x120);  // notice: EventsLost

/// The reply to kPing.
struct Pong {
  /// Time at which the reply was made; ns, on the steady clock of its sender.
  std::int64_t time = 0;
};

/// Asks for a connection.
struct OpenInterface {
  InterfaceName required;
  InterfaceName provided;
  RequiredDescription description;  ///< the required interface: its functions and event handlers
  std::uint32_t handle = 0;         ///< the opener's number; its members are the event handlers
  std::uint32_t capacity = 0;       ///< capacity of the queues for calls and for events
  std::vector<std::string> latest_only{};  ///< event handlers that keep only the latest event
};

/// Confirms the connection.
struct OpenInterfaceReply {
  std::uint32_t handle = 0;  ///< number of the provided side; its members are the functions
  std::uint32_t credit = 0;  ///< number of calls that may be sent before the first Credit
  bool accepting = false;    ///< true if the component executes calls now
  ProvidedDescription description;
  std::vector<std::string> latest_only{};  ///< commands that keep only the latest call
};

/// The number of calls that the component has executed, and its state. Sent within 5 ms after each
/// change.
struct Credit {
  std::uint64_t executed = 0;  ///< number of calls executed since the connection was opened
  bool accepting = false;
  std::string fault;  ///< the reason if the component is faulted; otherwise empty

  bool operator==(const Credit&) const = default;
};

/// The number of events lost since the connection was opened, for each event handler. The end that
/// raises the events reports the events that it could not send. The end that handles the events
/// reports the events that arrived but did not reach a handler.
struct EventsLost {
  /// The largest increase of a number from one report to the next. It is limited because the
  /// receiver counts the events one by one.
  static constexpr std::uint64_t kMaxAtOnce = 65536;

  std::vector<std::uint64_t> lost;

  bool operator==(const EventsLost&) const = default;
};

// Messages for mirrored values: copies of the newest values that another process reads.

// Sent by the process of a required interface before it opens the provided interface. The copies
// arrive as rows with one column, as after kSubscribe, but only the newest row is sent.
inline constexpr auto kMirror = static_cast<MessageType>(0x20b);  // request: Mirror -> MirrorReply

// Sent by the other end. A notice with a bool, which is true if the read command is enabled. The
// handle is the handle of the copies.
inline constexpr auto kMirrorTurned = static_cast<MessageType>(0x20c);

/// Asks for copies of the results of read commands that return the newest value of a column.
struct Mirror {
  InterfaceName provided;
  std::vector<std::string> commands;
};

/// One mirrored command. All fields are zero if there is no such command.
struct MirroredColumn {
  std::uint32_t handle = 0;      ///< handle of the frames with the copies
  std::uint32_t capacity = 0;    ///< size of the largest value in bytes
  std::int64_t time = 0;         ///< time of the newest row; ns, on the steady clock of its process
  std::vector<std::byte> value;  ///< value in that row; empty if the row has no value
};

/// The reply to kMirror, in the order of the request.
struct MirrorReply {
  std::vector<MirroredColumn> columns;
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::Pong> =
    tendon::Describe("tendon.Pong", tendon::Field{"time", &tendon::message::Pong::time, "ns"});

template <>
inline constexpr auto tendon::kPayload<tendon::message::OpenInterface> = tendon::Describe(
    "tendon.OpenInterface", tendon::Field{"required", &tendon::message::OpenInterface::required},
    tendon::Field{"provided", &tendon::message::OpenInterface::provided},
    tendon::Field{"description", &tendon::message::OpenInterface::description},
    tendon::Field{"handle", &tendon::message::OpenInterface::handle},
    tendon::Field{"capacity", &tendon::message::OpenInterface::capacity},
    tendon::Field{"latest_only", &tendon::message::OpenInterface::latest_only});

template <>
inline constexpr auto tendon::kPayload<tendon::message::OpenInterfaceReply> = tendon::Describe(
    "tendon.OpenInterfaceReply",
    tendon::Field{"handle", &tendon::message::OpenInterfaceReply::handle},
    tendon::Field{"credit", &tendon::message::OpenInterfaceReply::credit},
    tendon::Field{"accepting", &tendon::message::OpenInterfaceReply::accepting},
    tendon::Field{"description", &tendon::message::OpenInterfaceReply::description},
    tendon::Field{"latest_only", &tendon::message::OpenInterfaceReply::latest_only});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Credit> =
    tendon::Describe("tendon.Credit", tendon::Field{"executed", &tendon::message::Credit::executed},
                     tendon::Field{"accepting", &tendon::message::Credit::accepting},
                     tendon::Field{"fault", &tendon::message::Credit::fault});

template <>
inline constexpr auto tendon::kPayload<tendon::message::EventsLost> = tendon::Describe(
    "tendon.EventsLost", tendon::Field{"lost", &tendon::message::EventsLost::lost});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Mirror> =
    tendon::Describe("tendon.Mirror", tendon::Field{"provided", &tendon::message::Mirror::provided},
                     tendon::Field{"commands", &tendon::message::Mirror::commands});

template <>
inline constexpr auto tendon::kPayload<tendon::message::MirroredColumn> = tendon::Describe(
    "tendon.MirroredColumn", tendon::Field{"handle", &tendon::message::MirroredColumn::handle},
    tendon::Field{"capacity", &tendon::message::MirroredColumn::capacity},
    tendon::Field{"time", &tendon::message::MirroredColumn::time, "ns"},
    tendon::Field{"value", &tendon::message::MirroredColumn::value});

template <>
inline constexpr auto tendon::kPayload<tendon::message::MirrorReply> = tendon::Describe(
    "tendon.MirrorReply", tendon::Field{"columns", &tendon::message::MirrorReply::columns});
