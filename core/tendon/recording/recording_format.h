#pragma once

#include <tendon/base/name.h>
#include <tendon/payload/payload.h>
#include <tendon/recording/mcap/records.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

/// How Tendon uses MCAP. The writer, the reader, the replay and the exports use these rules.
///
/// - A column of a state table, an event or a command is a channel. Its topic is its path with
///   slashes: `robot/arm/state/Joints`. A row of a table is one message on each of the table's
///   channels; they have the same log time and sequence. The sequence is the low 32 bits of the
///   row's tick. Each event, and each call of a command, is one message. The log time of a call is
///   the time when its execution began; its type is the result of SchemaOfCalls().
/// - The log time is the time of this machine's clock, ns since 1970. The publish time is the time
///   on the clock of the source plus kClockKey.
/// - The data of a message is kEncapsulationSize bytes and then a CDR body, as in ROS 2. The schema
///   is a ROS 2 message definition; the channel's metadata has the Tendon schema, too.
/// - When a source is restarted, its ticks restart. For the new run, it gets new channels, with
///   another kEpochKey.
/// - The recorder writes the log, the losses and the catalogue on three separate topics.
/// - Metadata at the beginning and at the end of a file describe the recording, and an attachment
///   holds
///   the system file.
///
/// Names of Tendon's own metadata begin with `tendon.`, names of its own topics with `tendon/`.
namespace tendon::recording {

inline constexpr const char* kProfile = "ros2";
inline constexpr const char* kSchemaEncoding = "ros2msg";
inline constexpr const char* kMessageEncoding = "cdr";

// Topics of the recorder.
inline constexpr const char* kLogTopic = "rosout";                  // RosLog
inline constexpr const char* kLossTopic = "tendon/lost";            // Loss
inline constexpr const char* kCatalogueTopic = "tendon/catalogue";  // CatalogueChange

// Names of metadata and attachments.
inline constexpr const char* kAboutMetadata = "tendon.recording";  // at the beginning of each file
inline constexpr const char* kEndMetadata = "tendon.end";          // counts, at the end
inline constexpr const char* kLossMetadata = "tendon.lost";        // losses by path, at the end
inline constexpr const char* kSystemAttachment = "system.json";

// Keys of a channel's metadata.
inline constexpr const char* kKindKey = "tendon.kind";      // one of the kinds below
inline constexpr const char* kPathKey = "tendon.path";      // "robot/arm/state.Joints"
inline constexpr const char* kSchemaKey = "tendon.schema";  // Schema::TextWithHelp()
inline constexpr const char* kEpochKey = "tendon.epoch";    // which start of the source
/// The publish time minus the time on the steady clock of the source, in ns.
inline constexpr const char* kClockKey = "tendon.clock_ns";
/// The maximum error of the log time of a row, in ns, at the time when the channel was made.
/// Missing if it is unknown.
inline constexpr const char* kClockUncertaintyKey = "tendon.clock_uncertainty_ns";
/// The prefix of a key for the unit of a number; the path of its field follows:
/// "tendon.unit.position" is "rad".
inline constexpr const char* kUnitKey = "tendon.unit";

// Kinds of channels: values of kKindKey.
inline constexpr const char* kColumnKind = "column";
inline constexpr const char* kEventKind = "event";
inline constexpr const char* kCommandKind = "command";
inline constexpr const char* kOtherKind = "other";

/// The number of bytes before the CDR body of a message. These bytes say that the body is
/// little-endian.
inline constexpr std::size_t kEncapsulationSize = 4;

/// Returns the CDR body of a message; empty if the data is not little-endian CDR of the first
/// version. The body of a value is never empty.
[[nodiscard]] mcap::ByteView BodyOf(mcap::ByteView data);
/// Makes the data of a message from a CDR body. Reuses the memory of `data`.
void Encapsulate(mcap::ByteView body, mcap::Buffer& data);

/// Returns the value of a key in a channel's metadata; empty if there is none.
[[nodiscard]] std::string MetadataValue(const mcap::Channel& channel, const char* key);

/// "robot/arm/state/Joints"
[[nodiscard]] std::string TopicOf(const InterfaceName& source, const std::string& member);

/// A loss of rows: a message on kLossTopic, just before the rows that follow the loss.
struct Loss {
  std::string path;  ///< of the table
  /// Rows that the table overwrote before its process could read them.
  std::uint64_t table = 0;
  /// Rows that were lost between the process and the recorder.
  std::uint64_t network = 0;
  /// Rows that were lost because the disk was too slow or failed.
  std::uint64_t recorder = 0;

  bool operator==(const Loss&) const = default;
};

/// A record of the log, as ROS 2 tools expect it: rcl_interfaces/msg/Log.
struct RosLog {
  std::chrono::nanoseconds stamp{0};  ///< since 1970
  std::uint8_t level = 0;             ///< 10 debug, 20 info, 30 warning, 40 error
  std::string name;                   ///< "robot/arm"
  std::string msg;
  std::string file;
  std::string function;
  std::uint32_t line = 0;
};

/// Returns the ROS 2 message definition of RosLog. It is written by hand, because Schema cannot
/// express the type of `stamp`, builtin_interfaces/Time.
[[nodiscard]] const char* RosLogDefinition();

}  // namespace tendon::recording

template <>
inline constexpr auto tendon::kPayload<tendon::recording::Loss> =
    tendon::Describe("tendon.Loss", tendon::Field{"path", &tendon::recording::Loss::path},
                     tendon::Field{"table", &tendon::recording::Loss::table},
                     tendon::Field{"network", &tendon::recording::Loss::network},
                     tendon::Field{"recorder", &tendon::recording::Loss::recorder});
template <>
inline constexpr auto tendon::kPayload<tendon::recording::RosLog> = tendon::Describe(
    "rcl_interfaces.Log", tendon::Field{"stamp", &tendon::recording::RosLog::stamp},
    tendon::Field{"level", &tendon::recording::RosLog::level},
    tendon::Field{"name", &tendon::recording::RosLog::name},
    tendon::Field{"msg", &tendon::recording::RosLog::msg},
    tendon::Field{"file", &tendon::recording::RosLog::file},
    tendon::Field{"function", &tendon::recording::RosLog::function},
    tendon::Field{"line", &tendon::recording::RosLog::line});
