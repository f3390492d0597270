#pragma once

#include <tendon/base/log.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/payload.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

template <>
inline constexpr auto kPayload<LogLevel> = DescribeEnum("tendon.LogLevel",
                                                        Enumerator{"debug", LogLevel::kDebug},
                                                        Enumerator{"info", LogLevel::kInfo},
                                                        Enumerator{"warning", LogLevel::kWarning},
                                                        Enumerator{"error", LogLevel::kError});

[[nodiscard]] constexpr std::string_view ToString(LogLevel level) noexcept { return NameOf(level); }

}  // namespace tendon

/// Messages that carry log records from processes to a GCM, and from there to its viewers. Each
/// struct is the body of a frame.
namespace tendon::message {

// A notice with LogRecords, from an LCM to its GCM, and from the GCM to a viewer that watches the
// log.
inline constexpr auto kLogRecords = static_cast<MessageType>(0x340);
// A request SetLogLevel -> None, from a viewer to its GCM, and from the GCM to the LCM.
inline constexpr auto kSetLogLevel = static_cast<MessageType>(0x341);

/// The largest kLogRecords that a GCM reads, in bytes.
inline constexpr std::size_t kLargestLogBatch = std::size_t{1} << 20U;

/// One line of the log, for people.
struct LogRecord {
  std::int64_t time = 0;  ///< ns since 1970, on the clock of the process's host
  LogLevel level = LogLevel::kInfo;
  std::string process;  ///< empty if an LCM sends the record, because the GCM knows the name
  std::string source;   ///< the name of a component or a part of the program
  std::string text;

  bool operator==(const LogRecord&) const = default;
};

/// The next records, oldest first.
struct LogRecords {
  /// Number of earlier records that an LCM has sent or a GCM has received. A gap between two
  /// messages means that records were lost.
  std::uint64_t before = 0;
  std::vector<LogRecord> records;
};

/// Drops records below `level` in the whole process, until the level is set again.
struct SetLogLevel {
  std::string process;
  LogLevel level = LogLevel::kInfo;
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::LogRecord> = tendon::Describe(
    "tendon.LogRecord", tendon::Field{"time", &tendon::message::LogRecord::time, "ns"},
    tendon::Field{"level", &tendon::message::LogRecord::level},
    tendon::Field{"process", &tendon::message::LogRecord::process},
    tendon::Field{"source", &tendon::message::LogRecord::source},
    tendon::Field{"text", &tendon::message::LogRecord::text});

template <>
inline constexpr auto tendon::kPayload<tendon::message::LogRecords> = tendon::Describe(
    "tendon.LogRecords", tendon::Field{"before", &tendon::message::LogRecords::before},
    tendon::Field{"records", &tendon::message::LogRecords::records});

template <>
inline constexpr auto tendon::kPayload<tendon::message::SetLogLevel> = tendon::Describe(
    "tendon.SetLogLevel", tendon::Field{"process", &tendon::message::SetLogLevel::process},
    tendon::Field{"level", &tendon::message::SetLogLevel::level});
