#pragma once

#include <tendon/payload/payload.h>
#include <tendon/recording/mcap/compression.h>

#include <cstdint>
#include <string>
#include <vector>

/// A component that records its own process.
namespace recorder {

using tendon::mcap::Compression;

inline constexpr double kLongestSplit = 30.0 * 24 * 3600;  // s
inline constexpr double kLongestAround = 3600.0;           // s, before and after conditions

struct RecorderConfiguration {
  std::vector<std::string> patterns{"**"};
  std::string folder = ".";
  std::string name = "recording";
  Compression compression = Compression::kZstd;
  std::uint64_t split_size = 0;  ///< bytes; 0: no limit
  double split_time = 0.0;       ///< s; 0: no limit
  std::uint64_t keep = 0;        ///< files of one recording; 0: all
  bool log = true;
  bool record_at_start = false;
  std::string start_when{};  ///< a condition; empty: begins at once
  std::string stop_when{};   ///< a condition; empty: only an order ends the recording
  double before = 0.0;       ///< s
  double after = 0.0;        ///< s
};

/// The state of a recording, or of the last one.
struct RecorderState {
  bool is_recording = false;
  bool is_waiting = false;  ///< for the condition to start
  std::uint64_t rows = 0;
  std::uint64_t events = 0;
  std::uint64_t commands = 0;   ///< calls
  std::uint64_t bytes = 0;      ///< of the files that are kept
  double rate = 0.0;            ///< bytes per second, over the last second
  std::uint64_t disk_left = 0;  ///< bytes
  std::uint64_t lost = 0;       ///< rows, events, calls and log records
};

}  // namespace recorder

template <>
inline constexpr auto tendon::kPayload<recorder::Compression> = tendon::DescribeEnum(
    "recorder.Compression",
    tendon::Enumerator{NameOf(recorder::Compression::kNone), recorder::Compression::kNone},
    tendon::Enumerator{NameOf(recorder::Compression::kLz4), recorder::Compression::kLz4},
    tendon::Enumerator{NameOf(recorder::Compression::kZstd), recorder::Compression::kZstd});

template <>
inline constexpr auto tendon::kPayload<recorder::RecorderConfiguration> = tendon::Describe(
    "recorder.RecorderConfiguration",
    tendon::Field{"patterns", &recorder::RecorderConfiguration::patterns}.Help(
        "Paths or patterns of objects in this process, such as robot/arm/**."),
    tendon::Field{"folder", &recorder::RecorderConfiguration::folder}.Help(
        "Folder for the files. The folder must exist."),
    tendon::Field{"name", &recorder::RecorderConfiguration::name}.Help(
        "Start of the file names; the date and the time are added."),
    tendon::Field{"compression", &recorder::RecorderConfiguration::compression},
    tendon::Field{"split_size", &recorder::RecorderConfiguration::split_size, "B"}.Help(
        "Size at which another file begins; 0 means no limit."),
    tendon::Field{"split_time", &recorder::RecorderConfiguration::split_time, "s"}
        .Within(0.0, recorder::kLongestSplit)
        .Help("Time after which another file begins; 0 means no limit."),
    tendon::Field{"keep", &recorder::RecorderConfiguration::keep}.Help(
        "Number of the newest files to keep; 0 means all files."),
    tendon::Field{"log", &recorder::RecorderConfiguration::log}.Help(
        "Also record the log of this process."),
    tendon::Field{"record_at_start", &recorder::RecorderConfiguration::record_at_start}.Help(
        "Begin to record when the component starts."),
    tendon::Field{"start_when", &recorder::RecorderConfiguration::start_when}.Help(
        "Event, command or condition, such as robot/arm/state.Joints.position[2] > 1.2 rad, before "
        "which nothing is written; empty means none."),
    tendon::Field{"stop_when", &recorder::RecorderConfiguration::stop_when}.Help(
        "Event, command or condition that ends the recording; empty means none."),
    tendon::Field{"before", &recorder::RecorderConfiguration::before, "s"}
        .Within(0.0, recorder::kLongestAround)
        .Help("With start_when: also write the data of this time before the start."),
    tendon::Field{"after", &recorder::RecorderConfiguration::after, "s"}
        .Within(0.0, recorder::kLongestAround)
        .Help("With stop_when: also write the data of this time after the condition."));

template <>
inline constexpr auto tendon::kPayload<recorder::RecorderState> = tendon::Describe(
    "recorder.RecorderState", tendon::Field{"is_recording", &recorder::RecorderState::is_recording},
    tendon::Field{"is_waiting", &recorder::RecorderState::is_waiting},
    tendon::Field{"rows", &recorder::RecorderState::rows},
    tendon::Field{"events", &recorder::RecorderState::events},
    tendon::Field{"commands", &recorder::RecorderState::commands},
    tendon::Field{"bytes", &recorder::RecorderState::bytes, "B"},
    tendon::Field{"rate", &recorder::RecorderState::rate, "B/s"},
    tendon::Field{"disk_left", &recorder::RecorderState::disk_left, "B"},
    tendon::Field{"lost", &recorder::RecorderState::lost});
