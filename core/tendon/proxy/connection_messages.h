#pragma once

#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>

#include <cstdint>
#include <string>
#include <vector>

/// The messages between the two ends of a connection. The opener is the process of the required
/// interface. Each struct is the body of a frame; requests are answered, notices are not. Each end
/// issues a number for the connection, which the other end puts into the header's handle. The
/// handle of member i is this number + 1 + i.
namespace tendon::message {

// From the opener.
inline constexpr auto kOpenInterface =
    static_cast<MessageType>(0x100);  // request: OpenInterface -> OpenInterfaceReply
inline constexpr auto kCloseInterface = static_cast<MessageType>(0x101);  // notice: empty
// notice: calls of functions, as a CallBatch
inline constexpr auto kCommands = static_cast<MessageType>(0x102);
// request to a function's handle: the argument -> the result, followed by one byte of Status::Code
inline constexpr auto kRead = static_cast<MessageType>(0x103);
inline constexpr auto kPing = static_cast<MessageType>(0x104);  // request: None -> Pong
// request to a function's handle: the argument, followed by u64, the caller's timeout in ns -> the
// same reply as to kRead, sent after the call was executed or refused
inline constexpr auto kWait = static_cast<MessageType>(0x105);
// From the peer.
// notice: calls of event handlers, as a CallBatch
inline constexpr auto kEvents = static_cast<MessageType>(0x110);
inline constexpr auto kCredit = static_cast<MessageType>(0x111);  // notice: Credit
// The reply to an executed kWait also acts as a Credit: all calls sent before it were executed too.
// notice: Error; the provided interface is gone
inline constexpr auto kInterfaceClosed = static_cast<MessageType>(0x112);
// notice, to a listener without functions: as kEvents, each value with its time (AddTimed())
inline constexpr auto kTimedEvents = static_cast<MessageType>(0x113);
// From either end.
inline constexpr auto kEventsLost = static_cast<MessageType>(0x120);  // notice: EventsLost

/// The answer to kPing.
struct Pong {
  std::int64_t time = 0;  ///< when the reply was made, ns on the peer's steady clock
};

/// Asks for a connection.
struct OpenInterface {
  InterfaceName required;
  InterfaceName provided;
  RequiredDescription description;  ///< the required interface: its functions and event handlers
  std::uint32_t handle = 0;         ///< the opener's number; its members are the event handlers
  std::uint32_t capacity = 0;       ///< calls, and events, that may wait at a time
  std::vector<std::string> latest_only{};  ///< event handlers that keep the latest event only
};

/// Confirms the connection.
struct OpenInterfaceReply {
  std::uint32_t handle = 0;  ///< the peer's number; its members are the functions
  std::uint32_t credit = 0;  ///< calls that may be sent before the first Credit
  bool accepting = false;    ///< whether the component executes calls now
  ProvidedDescription description;
  std::vector<std::string> latest_only{};  ///< commands that keep the latest call only
};

/// How many calls the component has executed, and its state. Sent within 5 ms of each change.
struct Credit {
  std::uint64_t executed = 0;  ///< calls taken from its mailbox since the connection was opened
  bool accepting = false;
  std::string fault;  ///< why the component is faulted; otherwise empty

  bool operator==(const Credit&) const = default;
};

/// Events lost since the connection was opened, by event handler. The end that raises events
/// reports those that it could not send; the end that handles them, those that it lost after
/// arrival.
struct EventsLost {
  /// The largest increase from one report to the next, because the receiver counts each event in a
  /// loop.
  static constexpr std::uint64_t kMostAtOnce = 65536;

  std::vector<std::uint64_t> lost;

  bool operator==(const EventsLost&) const = default;
};

// Copies of values that another process reads.

// From the process of a required interface, before it opens the provided one. The copies arrive as
// rows of one column, the newest only, as after kSubscribe.
inline constexpr auto kMirror = static_cast<MessageType>(0x20b);  // request: Mirror -> MirrorReply

// From the peer.
// notice: bool, whether the read command is enabled; the handle is that of its copies
inline constexpr auto kMirrorTurned = static_cast<MessageType>(0x20c);

/// Asks for copies of read commands that return the newest value of a column.
struct Mirror {
  InterfaceName provided;
  std::vector<std::string> commands;
};

/// One mirrored command; all zero if there is no such command.
struct MirroredColumn {
  std::uint32_t handle = 0;      ///< handle of the frames with its copies
  std::uint32_t capacity = 0;    ///< size of its largest value in bytes
  std::int64_t time = 0;         ///< time of the newest row, ns on the source's steady clock
  std::vector<std::byte> value;  ///< value in that row; empty if there is none
};

/// The answer to kMirror, in the order asked for.
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
