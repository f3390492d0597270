#pragma once

#include <tendon/manager/component_description.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/telemetry/row_choice.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The requests that viewers send directly to a process: schemas, calls, events, and rows of state
/// tables. Each struct is the body of a frame; requests are answered, notices are not.
namespace tendon::message {

// From a viewer.
inline constexpr auto kGetSchemas =
    static_cast<MessageType>(0x200);  // request: GetSchemas -> Schemas
inline constexpr auto kCallMember =
    static_cast<MessageType>(0x201);  // request: CallMember -> CallMemberReply
inline constexpr auto kSubscribe =
    static_cast<MessageType>(0x202);  // request: Subscribe -> SubscribeReply
inline constexpr auto kUnsubscribe = static_cast<MessageType>(0x203);  // notice: a handle, no body
// From the process.
inline constexpr auto kRows =
    static_cast<MessageType>(0x204);  // notice: a handle, then RowsHeader and the rows
// The Error says why there are no more rows.
inline constexpr auto kRowsEnded = static_cast<MessageType>(0x205);  // notice: a handle, then Error
// From a viewer that wants only the newest row: it has received the last row, so the process may
// send the next row.
inline constexpr auto kRowTaken = static_cast<MessageType>(0x206);  // notice: a handle, no body
// From a viewer: like kOpenInterface, but without functions. A handler may have the name of a
// command; then it receives the calls of the command, see interface/observed_call.h. Afterwards,
// the process sends kTimedEvents, kEventsLost and kInterfaceClosed, and the viewer sends
// kCloseInterface, as in proxy/connection_messages.h.
inline constexpr auto kListen =
    static_cast<MessageType>(0x207);  // request: OpenInterface -> OpenInterfaceReply

/// kGetCounts requests the counts of a connection whose required side is in the process. kGetFill
/// requests the fill levels of a component's mailboxes.
inline constexpr auto kGetCounts =
    static_cast<MessageType>(0x208);  // request: GetCounts -> ConnectionCounts
inline constexpr auto kGetFill =
    static_cast<MessageType>(0x209);  // request: GetFill -> MailboxFill

/// Reads the rows of a state table that are already written, page by page.
inline constexpr auto kReadRows =
    static_cast<MessageType>(0x20e);  // request: ReadRows -> ReadRowsReply

/// Names the required side of a connection. The process of the provided side also answers, but only
/// with the capacity and the lost events of the provided side.
struct GetCounts {
  InterfaceName required;
};

/// Names the component whose mailboxes are read.
struct GetFill {
  std::string component;
};

/// The payload types whose schemas are requested.
struct GetSchemas {
  std::vector<Fingerprint> fingerprints;
};

/// Schema::Text() of each type, in the order of the request. A text is empty if the process does
/// not know the type.
struct Schemas {
  std::vector<std::string> texts;
};

/// Executes a command. Columns of state tables are read commands too: interface "state" or
/// "state-NAME", member = column.
struct CallMember {
  std::string component;
  std::string interface;
  std::string member;
  std::vector<std::byte> argument;  ///< the encoded argument; empty if the command takes none
  std::chrono::nanoseconds timeout{2'000'000'000};  ///< for commands with a waiting caller
};

/// The outcome of a call.
struct CallMemberReply {
  std::uint8_t status = 0;        ///< Status::Code
  std::vector<std::byte> result;  ///< the encoded result; empty without a result
};

/// Subscribes to rows of one state table, until kUnsubscribe or the channel's end. No column may be
/// named twice. TelemetryServer documents the limits.
struct Subscribe {
  std::string component;
  std::string table;  ///< "state" or "state-NAME"
  std::vector<std::string> columns;
  RowChoice rows;
};

/// The reply to Subscribe.
struct SubscribeReply {
  std::uint32_t handle = 0;  ///< the handle in the frames of this subscription
  std::uint64_t epoch = 0;   ///< StateTable::epoch(); in another epoch, ticks start again at 0
  /// The tick of the first row that will be sent or reported as lost. In a subscription to only the
  /// newest row, the first row may be older.
  std::uint64_t first_tick = 0;
  std::vector<std::string> schemas;  ///< Schema::Text() of each column, in the order of the request
};

/// Asks for the kept rows of one state table. The first request has the epoch 0. Each later request
/// continues where the previous reply has ended.
struct ReadRows {
  std::string component;
  std::string table;  ///< "state" or "state-NAME"
  std::vector<std::string> columns;
  /// Only in the first request: the largest age of a row.
  std::chrono::nanoseconds last{0};
  std::uint64_t epoch = 0;        ///< the epoch of the first reply
  std::uint64_t first_tick = 0;   ///< RowsHeader::next_tick of the last reply
  std::uint64_t rows_before = 0;  ///< rows that the viewer has received in earlier replies
};

/// The reply to ReadRows: as many rows as fit into 128 KiB. If any row is left, the reply has at
/// least one.
struct ReadRowsReply {
  SubscribeReply subscribed;    ///< without a handle; `first_tick` is the first tick of these rows
  std::int64_t now = 0;         ///< ns, on the steady clock of the process
  std::uint64_t end_tick = 0;   ///< the tick of the next row that will be written
  std::vector<std::byte> rows;  ///< the body of a kRows
};

/// The body of kRows, little-endian. The layout lets a reader find each cell with one addition:
///
///     RowsHeader
///     u32 x columns    bytes of a cell of that column, or 0 if they differ from row to row
///     padding to 8
///     row x rows       u64 tick, i64 time (ns on the source's steady clock), then for each
///                      column, at the next multiple of 8, one of:
///                      - the cell's body, if the size of the column above is not 0;
///                      - otherwise u32 offset, u32 size of a body that follows the rows
///     the cells whose sizes differ, each at a multiple of 8; their offsets count from the start
///                      of the frame's body
///
/// A row is a multiple of 8 bytes long; all rows of a batch are equally long.
///
/// An empty batch reports rows that the link has refused. It is sent if no other batch follows.
struct RowsHeader {
  std::uint64_t rows_before = 0;  ///< rows sent earlier in this subscription; a gap means lost rows
  /// Rows since the last batch that were overwritten before the source could read them.
  std::uint64_t lost_table = 0;
  std::uint64_t next_tick = 0;  ///< all rows with smaller ticks are in this and earlier batches
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
inline constexpr auto tendon::kPayload<tendon::message::CallMemberReply> = tendon::Describe(
    "tendon.CallMemberReply", tendon::Field{"status", &tendon::message::CallMemberReply::status},
    tendon::Field{"result", &tendon::message::CallMemberReply::result});

template <>
inline constexpr auto tendon::kPayload<tendon::message::Subscribe> = tendon::Describe(
    "tendon.Subscribe", tendon::Field{"component", &tendon::message::Subscribe::component},
    tendon::Field{"table", &tendon::message::Subscribe::table},
    tendon::Field{"columns", &tendon::message::Subscribe::columns},
    tendon::Field{"rows", &tendon::message::Subscribe::rows});

template <>
inline constexpr auto tendon::kPayload<tendon::message::SubscribeReply> = tendon::Describe(
    "tendon.SubscribeReply", tendon::Field{"handle", &tendon::message::SubscribeReply::handle},
    tendon::Field{"epoch", &tendon::message::SubscribeReply::epoch},
    tendon::Field{"first_tick", &tendon::message::SubscribeReply::first_tick},
    tendon::Field{"schemas", &tendon::message::SubscribeReply::schemas});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ReadRows> = tendon::Describe(
    "tendon.ReadRows", tendon::Field{"component", &tendon::message::ReadRows::component},
    tendon::Field{"table", &tendon::message::ReadRows::table},
    tendon::Field{"columns", &tendon::message::ReadRows::columns},
    tendon::Field{"last", &tendon::message::ReadRows::last},
    tendon::Field{"epoch", &tendon::message::ReadRows::epoch},
    tendon::Field{"first_tick", &tendon::message::ReadRows::first_tick},
    tendon::Field{"rows_before", &tendon::message::ReadRows::rows_before});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ReadRowsReply> =
    tendon::Describe("tendon.ReadRowsReply",
                     tendon::Field{"subscribed", &tendon::message::ReadRowsReply::subscribed},
                     tendon::Field{"now", &tendon::message::ReadRowsReply::now, "ns"},
                     tendon::Field{"end_tick", &tendon::message::ReadRowsReply::end_tick},
                     tendon::Field{"rows", &tendon::message::ReadRowsReply::rows});

template <>
inline constexpr auto tendon::kPayload<tendon::message::RowsHeader> = tendon::Describe(
    "tendon.RowsHeader", tendon::Field{"rows_before", &tendon::message::RowsHeader::rows_before},
    tendon::Field{"lost_table", &tendon::message::RowsHeader::lost_table},
    tendon::Field{"next_tick", &tendon::message::RowsHeader::next_tick},
    tendon::Field{"rows", &tendon::message::RowsHeader::rows},
    tendon::Field{"columns", &tendon::message::RowsHeader::columns});
