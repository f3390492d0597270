#pragma once

#include <gcm_console/verbs/verb.h>
#include <tendon/recording/mcap/compression.h>
#include <tendon/recording/mcap/reader.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Options and functions of the verbs that read or write recordings.
namespace console {

/// A part of a recording, as given on the command line.
struct RecordingPart {
  std::string file;
  std::string output;
  double from = 0.0;  // s since the first message
  double to = 0.0;    // s since the first message; 0: up to the end
  std::vector<std::string> paths;
};

/// Adds --compression, for the verbs that write a recording.
void AddCompression(CLI::App& app, tendon::mcap::Compression& compression);
/// Adds the argument for the file name.
void AddRecordingFile(CLI::App& app, std::string& file);
/// Adds --from, --to and --paths.
void AddRecordingPart(CLI::App& app, RecordingPart& options);

/// Returns the path of the channel's object in the system; if it has none, the topic.
std::string ChannelPath(const tendon::mcap::Channel& channel);

/// Returns the times of the first and the last message; empty if there are no messages.
std::optional<std::pair<tendon::mcap::Timestamp, tendon::mcap::Timestamp>> RecordingTimes(
    const tendon::mcap::Reader& reader);

/// Returns the query for the messages of the part. Returns kNotFound if a path matches nothing.
Result<tendon::mcap::Query> PartQuery(const tendon::mcap::Reader& reader,
                                      const RecordingPart& options);

/// Returns true once after the user has asked the program to stop.
bool IsInterrupted();
/// Returns the result of work that has failed: `failure`, unless IsInterrupted() has stopped the
/// work.
Result<ExitCode> FailureOf(Context& context, const Error& failure);

/// Prints the problems of a file. Returns the exit code: kOk if there are no problems.
ExitCode PrintProblems(Context& context, const std::vector<tendon::mcap::Problem>& problems,
                       std::uint64_t count);

}  // namespace console
