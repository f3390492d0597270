#include <gcm_console/verbs/recording_part.h>

#include <gcm_console/output/recording_text.h>
#include <gcm_console/output/text.h>
#include <program/command_line.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/recording/recording_format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <limits>

namespace console {
namespace {

namespace mcap = tendon::mcap;

constexpr double kNanosecondsPerSecond = 1e9;

mcap::Timestamp After(mcap::Timestamp begin, double seconds) {
  const double most = static_cast<double>(std::numeric_limits<std::int64_t>::max());
  return begin + static_cast<mcap::Timestamp>(std::min(seconds * kNanosecondsPerSecond, most));
}

}  // namespace

void AddCompression(CLI::App& app, mcap::Compression& compression) {
  std::vector<std::string> names;
  for (const mcap::Compression one : mcap::kCompressions) names.emplace_back(mcap::NameOf(one));
  app.add_option_function<std::string>(
         "--compression",
         [&compression](const std::string& name) {
           const auto parsed = mcap::ParseCompression(name);
           if (!parsed) throw CLI::ValidationError("--compression", parsed.error().message);
           compression = *parsed;
         },
         "zstd (default), lz4 or none")
      ->type_name("TEXT:{" + tendon::Joined(names, ",") + "}");
}

void AddRecordingFile(CLI::App& app, std::string& file) {
  WithKind(app.add_option("file", file, "a recording, such as run.mcap"), WordKind::kFile)
      ->required();
}

void AddRecordingPart(CLI::App& app, RecordingPart& options) {
  app.add_option("--from", options.from,
                 "omit everything before this time, counted from the first message, such as 10s")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--to", options.to,
                 "omit everything from this time on, counted from the first message")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--paths", options.paths,
                 "use only these topics or paths, written as in gcm record, with * and **");
}

std::string ChannelPath(const mcap::Channel& channel) {
  const std::string path = tendon::recording::MetadataValue(channel, tendon::recording::kPathKey);
  return path.empty() ? channel.topic : path;
}

std::optional<std::pair<mcap::Timestamp, mcap::Timestamp>> RecordingTimes(
    const mcap::Reader& reader) {
  const auto& statistics = reader.statistics();
  if (statistics && statistics->message_count > 0) {
    return std::pair(statistics->message_start_time, statistics->message_end_time);
  }
  if (statistics || reader.blocks().empty()) return std::nullopt;
  std::pair<mcap::Timestamp, mcap::Timestamp> times(mcap::kLastTime, mcap::kFirstTime);
  for (const auto& block : reader.blocks()) {
    if (block.index.message_end_time == 0) continue;  // without messages
    times.first = std::min(times.first, block.index.message_start_time);
    times.second = std::max(times.second, block.index.message_end_time);
  }
  return times.first <= times.second ? std::optional(times) : std::nullopt;
}

Result<mcap::Query> PartQuery(const mcap::Reader& reader, const RecordingPart& options) {
  mcap::Query query;
  const auto times = RecordingTimes(reader);
  const mcap::Timestamp begin = times ? times->first : 0;
  if (options.from > 0.0) query.from = After(begin, options.from);
  if (options.to > 0.0) query.to = After(begin, options.to) - 1;
  if (query.to < query.from) {
    return Error{ErrorCode::kInvalid, "--to must be after --from: give a later time for --to"};
  }
  for (const std::string& pattern : options.paths) {
    const std::size_t before = query.channels.size();
    for (const auto& [id, channel] : reader.channels()) {
      if (tendon::IsWithinGlob(pattern, ChannelPath(channel)) ||
          tendon::IsWithinGlob(pattern, channel.topic)) {
        query.channels.push_back(id);
      }
    }
    if (query.channels.size() == before) {
      return Error{ErrorCode::kNotFound, "nothing in " + options.file + " matches '" + pattern +
                                             "'; to list the content: gcm info " + options.file};
    }
  }
  return query;
}

bool IsInterrupted() { return tendon::os::TerminationRequested(std::chrono::milliseconds(0)); }

Result<ExitCode> FailureOf(Context& context, const Error& failure) {
  if (!tendon::os::WasTerminationRequested()) return failure;
  context.err() << "gcm: " << Plain(failure.message) << '\n';
  return program::kInterrupted;
}

ExitCode PrintProblems(Context& context, const std::vector<mcap::Problem>& problems,
                       std::uint64_t count) {
  PrintSentences(ProblemTexts(problems, count), context.err());
  return count > 0 ? program::kPartial : program::kOk;
}

}  // namespace console
