#pragma once

#include <tendon/manager/description.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/telemetry/row_choice.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What viewers ask a process directly: schemas, calls, events, and the rows of state tables. Each
/// struct is the body of a frame; requests are answered, notices are not.
namespace tendon::message {

// From a viewer.
inline constexpr auto kGetSchemas =
    static_cast<MessageType>(0x200);  // request: GetSchemas -> Schemas
inline constexpr auto kCallMember =
    static_cast<MessageType>(0x201);  // request: CallMember -> Called
inline constexpr auto kSubscribe =
    static_cast<MessageType>(0x202);  // request: Subscribe -> Subscribed
inline constexpr auto kUnsubscribe =
    static_cast<MessageType>(0x203);  // notice: empty; frame's handle
// From the process.
inline constexpr auto kRows =
    static_cast<MessageType>(0x204);  // notice: frame's handle, see RowsHeader
inline constexpr auto kRowsEnded =
    static_cast<MessageType>(0x205);  // notice: frame's handle; Error: why no more rows come
// From a viewer that wants the newest row only: it has taken the last, the next may be sent.
inline constexpr auto kRowTaken = static_cast<MessageType>(0x206);  // notice: empty; frame's handle
// From a viewer: as kOpenInterface, but without functions. What follows is as in proxy/messages.h:
// kTimedEvents, kEventsLost and kInterfaceClosed from the process, kCloseInterface from the viewer.
inline constexpr auto kListen =
    static_cast<MessageType>(0x207);  // request: OpenInterface -> InterfaceOpened

/// How a connection, whose required side is in the process, and the mailboxes of a component do.
inline constexpr auto kGetCounts =
    static_cast<MessageType>(0x208);  // request: GetCounts -> ConnectionCounts
inline constexpr auto kGetFill =
    static_cast<MessageType>(0x209);  // request: GetFill -> MailboxFill

/// By the interface's name, which is that of the required side. Asked of the process of the
/// provided side it tells of that end alone: its capacity and its lost events.
struct GetCounts {
  InterfaceName required;
};

/// By the component's name.
struct GetFill {
  std::string component;
};

/// Which payload types' schemas are wanted.
struct GetSchemas {
  std::vector<Fingerprint> fingerprints;
};

/// Schema::Text() of each, in the order asked for; empty where the process does not know it.
struct Schemas {
  std::vector<std::string> texts;
};

/// Executes a command. The columns of state tables are read commands too: interface "state" or
/// "state-NAME", member = column.
struct CallMember {
  std::string component;
  std::string interface;
  std::string member;
  std::vector<std::byte> argument;  ///< the argument's body; empty where the command takes none
  std::chrono::nanoseconds timeout{2'000'000'000};  ///< of a command that its caller waits for
};

/// How a call has ended.
struct Called {
  std::uint8_t status = 0;        ///< Status::Code
  std::vector<std::byte> answer;  ///< the result's body; empty where there is none
};

/// Rows of one state table from now on, until kUnsubscribe or the channel's end. No column twice;
/// how many there may be of these says TelemetryServer.
struct Subscribe {
  std::string component;
  std::string table;  ///< "state" or "state-NAME"
  std::vector<std::string> columns;
  RowChoice rows;
};

/// The answer to Subscribe.
struct Subscribed {
  std::uint32_t handle = 0;  ///< of the frames of this subscription
  std::uint64_t epoch = 0;   ///< StateTable::epoch(): ticks of another mean other rows
  /// Of every row, that of the first which comes or is told of as lost; the newest only may be
  /// older.
  std::uint64_t first_tick = 0;
  std::vector<std::string> schemas;  ///< Schema::Text() of each column, in the order asked for
};

/// The body of kRows, little-endian, so laid out that each cell is found by one addition:
///
///     RowsHeader
///     u32 x columns    bytes of a cell of that column, or 0 where they differ from row to row
///     padding to 8
///     row x rows       u64 tick, i64 time (ns on the source's steady clock), then per column, at
///                      the next multiple of 8: the cell's body; or, where its size is 0, u32
///                      offset (from the start of the frame's body, a multiple of 8), u32 size
///     the cells whose sizes differ, each at a multiple of 8
///
/// A row is a multiple of 8 bytes long; all rows of a batch are equally long.
///
/// A viewer that was refused rows and hears of no others gets an empty batch, so that it can count.
struct RowsHeader {
  std::uint64_t rows_before = 0;  ///< sent before in this subscription: a hole is a loss on the way
  /// Overwritten before they could be gathered, since the last batch.
  std::uint64_t lost_table = 0;
  std::uint64_t next_tick = 0;  ///< up to it, all rows are in this batch or were before
  std::uint32_t rows = 0;
  std::uint32_t columns = 0;
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::GetCounts> = tendon::Describe(
    "tendon.GetCounts", tendon::Field{"required", &tendon::message::GetCounts::required});

template <>
inline constexpr auto tendon::kPayload<tendon::message::GetFill> = tendon::Describe(
    "tendon.GetFill", tendon::Field{"component", &tendon::message::GetFill::component});

template <>
inline constexpr auto tendon::kPayload<tendon::message::GetSchemas> = tendon::Describe(
    "tendon.GetSchemas", tendon::Field{"fingerprints", &tendon::message::GetSchemas::fingerprints});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Schemas> =
    tendon::Describe("tendon.Schemas", tendon::Field{"texts", &tendon::message::Schemas::texts});

template <>
inline constexpr auto tendon::kPayload<tendon::message::CallMember> = tendon::Describe(
    "tendon.CallMember", tendon::Field{"component", &tendon::message::CallMember::component},
    tendon::Field{"interface", &tendon::message::CallMember::interface},
    tendon::Field{"member", &tendon::message::CallMember::member},
    tendon::Field{"argument", &tendon::message::CallMember::argument},
    tendon::Field{"timeout", &tendon::message::CallMember::timeout});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Called> =
    tendon::Describe("tendon.Called", tendon::Field{"status", &tendon::message::Called::status},
                     tendon::Field{"answer", &tendon::message::Called::answer});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Subscribe> = tendon::Describe(
    "tendon.Subscribe", tendon::Field{"component", &tendon::message::Subscribe::component},
    tendon::Field{"table", &tendon::message::Subscribe::table},
    tendon::Field{"columns", &tendon::message::Subscribe::columns},
    tendon::Field{"rows", &tendon::message::Subscribe::rows});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Subscribed> = tendon::Describe(
    "tendon.Subscribed", tendon::Field{"handle", &tendon::message::Subscribed::handle},
    tendon::Field{"epoch", &tendon::message::Subscribed::epoch},
    tendon::Field{"first_tick", &tendon::message::Subscribed::first_tick},
    tendon::Field{"schemas", &tendon::message::Subscribed::schemas});

template <>
inline constexpr auto tendon::kPayload<tendon::message::RowsHeader> = tendon::Describe(
    "tendon.RowsHeader", tendon::Field{"rows_before", &tendon::message::RowsHeader::rows_before},
    tendon::Field{"lost_table", &tendon::message::RowsHeader::lost_table},
    tendon::Field{"next_tick", &tendon::message::RowsHeader::next_tick},
    tendon::Field{"rows", &tendon::message::RowsHeader::rows},
    tendon::Field{"columns", &tendon::message::RowsHeader::columns});
