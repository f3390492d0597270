#pragma once

#include <tendon/middleware/frame.h>
#include <tendon/payload/payload.h>
#include <tendon/process/log/log_messages.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The requests for the events and log records that a process has kept. The rows that it has kept
/// are read with kReadRows. Each struct is the body of a frame. A process that runs an older
/// version refuses them.
namespace tendon::message {

// From a viewer.
inline constexpr auto kReadEvents =
    static_cast<MessageType>(0x218);  // request: ReadEvents -> ReadEventsReply
inline constexpr auto kReadLog =
    static_cast<MessageType>(0x219);  // request: ReadLog -> ReadLogReply
inline constexpr auto kGetProcessHistory =
    static_cast<MessageType>(0x21a);  // request: None -> ProcessHistoryState

/// Asks for the kept events of one provided interface. The first request has the epoch 0. Each
/// later request continues where the previous reply has ended.
struct ReadEvents {
  std::string component;
  std::string interface;
  /// Only in the first request: the age of the oldest event that is wanted.
  std::chrono::nanoseconds last{0};
  std::uint64_t epoch = 0;  ///< ReadEventsReply::epoch of the first reply
  std::uint64_t first = 0;  ///< ReadEventsReply::next of the previous reply
};

/// An event that was raised and is kept.
struct PastEvent {
  std::uint32_t event = 0;       ///< index in ReadEventsReply::events
  std::int64_t time = 0;         ///< ns, on the steady clock of the process
  std::vector<std::byte> value;  ///< a CDR body; empty if the event has no value
};

/// The reply to ReadEvents. It contains events of about 128 KiB, and at least one event if any
/// event is left.
struct ReadEventsReply {
  std::uint64_t epoch = 0;          ///< identifies the interface
  std::uint64_t next = 0;           ///< the number of the event after these
  std::uint64_t end = 0;            ///< the number of the next event that will be raised
  std::uint64_t lost = 0;           ///< events before these that are not kept
  std::vector<std::string> events;  ///< the names of all events of the interface
  std::vector<PastEvent> past;      ///< oldest first
};

/// Asks for the kept log records of the process, page by page.
struct ReadLog {
  std::chrono::nanoseconds last{0};  ///< the age of the oldest record that is wanted
  std::uint64_t first = 0;  ///< ReadLogReply::next of the previous reply; 0 in the first request
};

/// The reply to ReadLog.
struct ReadLogReply {
  std::uint64_t next = 0;          ///< the number of the record after these
  std::uint64_t end = 0;           ///< the number of the next record that will be written
  std::int64_t since = 0;          ///< all records after this time are kept; ns since 1970
  std::vector<LogRecord> records;  ///< oldest first, without the name of the process
};

/// The state of the history that a process keeps: its rows, events and log records.
struct ProcessHistoryState {
  std::uint64_t memory = 0;          ///< bytes in use
  std::uint64_t limit = 0;           ///< bytes at most; 0: the process keeps nothing
  std::chrono::nanoseconds span{0};  ///< older records are dropped
  std::chrono::nanoseconds age{0};   ///< the time since the history began
  /// All rows, events and log records that are younger than this are kept. It is at most `age` and
  /// at most `span`.
  std::chrono::nanoseconds reach{0};
  std::uint64_t missed_rows = 0;    ///< rows that could not be copied; usually overwritten before
  std::uint64_t missed_events = 0;  ///< events that came too fast or were too large
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::ReadEvents> = tendon::Describe(
    "tendon.ReadEvents", tendon::Field{"component", &tendon::message::ReadEvents::component},
    tendon::Field{"interface", &tendon::message::ReadEvents::interface},
    tendon::Field{"last", &tendon::message::ReadEvents::last},
    tendon::Field{"epoch", &tendon::message::ReadEvents::epoch},
    tendon::Field{"first", &tendon::message::ReadEvents::first});

template <>
inline constexpr auto tendon::kPayload<tendon::message::PastEvent> =
    tendon::Describe("tendon.PastEvent", tendon::Field{"event", &tendon::message::PastEvent::event},
                     tendon::Field{"time", &tendon::message::PastEvent::time, "ns"},
                     tendon::Field{"value", &tendon::message::PastEvent::value});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ReadEventsReply> = tendon::Describe(
    "tendon.ReadEventsReply", tendon::Field{"epoch", &tendon::message::ReadEventsReply::epoch},
    tendon::Field{"next", &tendon::message::ReadEventsReply::next},
    tendon::Field{"end", &tendon::message::ReadEventsReply::end},
    tendon::Field{"lost", &tendon::message::ReadEventsReply::lost},
    tendon::Field{"events", &tendon::message::ReadEventsReply::events},
    tendon::Field{"past", &tendon::message::ReadEventsReply::past});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ReadLog> =
    tendon::Describe("tendon.ReadLog", tendon::Field{"last", &tendon::message::ReadLog::last},
                     tendon::Field{"first", &tendon::message::ReadLog::first});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ReadLogReply> = tendon::Describe(
    "tendon.ReadLogReply", tendon::Field{"next", &tendon::message::ReadLogReply::next},
    tendon::Field{"end", &tendon::message::ReadLogReply::end},
    tendon::Field{"since", &tendon::message::ReadLogReply::since, "ns"},
    tendon::Field{"records", &tendon::message::ReadLogReply::records});

template <>
inline constexpr auto tendon::kPayload<tendon::message::ProcessHistoryState> = tendon::Describe(
    "tendon.ProcessHistoryState",
    tendon::Field{"memory", &tendon::message::ProcessHistoryState::memory, "B"},
    tendon::Field{"limit", &tendon::message::ProcessHistoryState::limit, "B"},
    tendon::Field{"span", &tendon::message::ProcessHistoryState::span},
    tendon::Field{"age", &tendon::message::ProcessHistoryState::age},
    tendon::Field{"reach", &tendon::message::ProcessHistoryState::reach},
    tendon::Field{"missed_rows", &tendon::message::ProcessHistoryState::missed_rows},
    tendon::Field{"missed_events", &tendon::message::ProcessHistoryState::missed_events});
