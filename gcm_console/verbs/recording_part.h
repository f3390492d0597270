#pragma once

#include <gcm_console/verbs/verb.h>
#include <tendon/recording/mcap_reader.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the verbs that read recordings have in common.
namespace console {

/// A part of a recording.
struct RecordingPart {
  std::string file;
  std::string output;
  double from = 0.0;  // s since the first message
  double to = 0.0;    // likewise; 0: no end
  std::vector<std::string> paths;
};

/// The name of the file.
void AddRecordingFile(CLI::App& app, std::string& file);
/// --from, --to and --paths.
void AddRecordingPart(CLI::App& app, RecordingPart& options);

/// The path of a channel in the system, or its topic.
std::string ChannelPath(const tendon::mcap::Channel& channel);

/// The times of the first and the last message; empty if there is none.
std::optional<std::pair<tendon::mcap::Timestamp, tendon::mcap::Timestamp>> RecordingTimes(
    const tendon::mcap::Reader& reader);

/// The messages of the part. kNotFound if a path fits nothing.
Result<tendon::mcap::Query> PartQuery(const tendon::mcap::Reader& reader,
                                      const RecordingPart& options);

/// Prints what is wrong with a file. Returns the exit code that says so.
ExitCode PrintProblems(Context& context, const std::vector<tendon::mcap::Problem>& problems,
                       std::uint64_t count);

}  // namespace console
