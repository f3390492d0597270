#include <gcm_console/output/recording_text.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/recording_part.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <program/network_options.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/recording/replay.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace console {
namespace {

using namespace std::chrono_literals;
using nlohmann::ordered_json;
using tendon::recording::Replay;
using tendon::recording::ReplayStatus;

struct ReplayWords {
  RecordingPart part;
  double rate = 1.0;
  bool loops = false;
  std::string as;
  double delay = 1.0;  // s
  std::string listen = "127.0.0.1:0";
};

/// The reason why a replay has ended. kUnsent: it has ended before all data was sent.
enum class ReplayEnd { kAtTheEnd, kInterrupted, kUnsent };

std::string FileNameOf(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

/// Returns kExists if a running process has one of the names.
Result<void> CheckNames(const tendon::Catalogue& catalogue, const Replay& replay,
                        const ReplayWords& words) {
  for (const std::string& name : replay.processes()) {
    const auto* entry = catalogue.FindProcess(name);
    if (entry == nullptr || entry->process.state == tendon::ProcessState::kLost ||
        entry->process.state == tendon::ProcessState::kLeft) {
      continue;
    }
    return Error{ErrorCode::kExists,
                 "cannot replay '" + name + "' of " + FileNameOf(words.part.file) +
                     ": the running system has a process with this name; end that process, or use "
                     "another name for the replay: --as NAME"};
  }
  return {};
}

Result<std::unique_ptr<tendon::Process>> MakeReplayProcess(const Context& context,
                                                           const std::string& name,
                                                           const std::string& listen) {
  auto middleware = program::MakeMiddleware(context.settings().network);
  if (!middleware) return middleware.error();
  try {
    return std::make_unique<tendon::Process>(
        name, tendon::ProcessOptions{
                  .middleware = *middleware, .gcm = context.settings().gcm, .listen = listen});
  } catch (const tendon::ConfigurationError& error) {
    return Error{error.code(), error.what()};
  }
}

void PrintReplayBegin(Context& context, const Replay& replay, const ReplayWords& words) {
  const std::string names = Joined(replay.processes(), ", ");
  const auto& contained = replay.contained();
  // Prints all in one write, because the replayed processes also log to this stream.
  context.err() << "gcm: replaying " + Plain(FileNameOf(words.part.file)) + " as " + Plain(names) +
                       ": " + tendon::Counted(contained.rows, "row", "rows") + ", " +
                       tendon::Counted(contained.events, "event", "events") + ", " +
                       tendon::Counted(contained.commands, "command", "commands") + ", " +
                       tendon::Counted(contained.log, "log record", "log records") + "\n";
  if (contained.left_out > 0) {
    context.err() << "gcm: " << tendon::Counted(contained.left_out, "message is", "messages are")
                  << " left out, because the channels do not describe their values, or the type of "
                     "a channel changes in the recording\n";
  }
}

void PrintReplayEnd(Context& context, const Replay& replay, const ReplayWords& words,
                    double seconds) {
  const ReplayStatus status = replay.status();
  const auto& problems = replay.reader().problems();
  if (context.settings().json) {
    ordered_json names = ordered_json::array();
    for (const std::string& name : replay.processes()) names.push_back(name);
    context.PrintJson({{"file", words.part.file},
                       {"processes", std::move(names)},
                       {"rate", words.rate},
                       {"seconds", seconds},
                       {"rows", status.rows},
                       {"events", status.events},
                       {"commands", status.commands},
                       {"log_records", status.log},
                       {"passes", status.passes},
                       {"left_out_messages", replay.contained().left_out},
                       {"left_out_log_records", status.log_left_out},
                       {"problems", ProblemTexts(problems.first(), problems.count())}});
  }
  context.err() << "gcm: replayed " << tendon::Counted(status.rows, "row", "rows") << ", "
                << tendon::Counted(status.events, "event", "events") << ", "
                << tendon::Counted(status.commands, "command", "commands") << ", "
                << tendon::Counted(status.log, "log record", "log records") << " in "
                << Fixed(seconds, 1) << " s\n";
  if (status.log_left_out > 0) {
    context.err() << "gcm: " << tendon::Counted(status.log_left_out, "log record", "log records")
                  << " of processes that are not replayed "
                  << (status.log_left_out == 1 ? "is" : "are") << " left out\n";
  }
  const double extended = std::chrono::duration<double>(status.extended).count();
  if (extended > 0.0) {
    context.err() << "gcm: the replay took " << Fixed(extended, 1)
                  << " s longer, because this machine was too slow for the rate\n";
  }
}

/// Waits until all data is sent: processes send rows every 20 ms, and events as fast as their
/// receivers accept them.
ReplayEnd SendRest(const Replay& replay) {
  constexpr auto kBetweenLooks = 5ms;
  constexpr auto kMaxWait = 5s;  // limit for a receiver that does not read
  const tendon::SteadyTime deadline = tendon::SteadyClock().Now() + kMaxWait;
  while (!replay.HasSentAll()) {
    if (tendon::os::TerminationRequested(kBetweenLooks)) return ReplayEnd::kInterrupted;
    if (tendon::SteadyClock().Now() >= deadline) return ReplayEnd::kUnsent;
  }
  return ReplayEnd::kAtTheEnd;
}

ReplayEnd PlayToTheEnd(Replay& replay) {
  constexpr auto kBetweenLooks = 10ms;
  auto next = replay.Play(tendon::SteadyClock().Now());
  while (next) {
    if (tendon::os::TerminationRequested(0ms)) return ReplayEnd::kInterrupted;
    const tendon::SteadyTime look = tendon::SteadyClock().Now() + kBetweenLooks;
    std::this_thread::sleep_until(std::min<tendon::SteadyTime>(*next, look));
    next = replay.Play(tendon::SteadyClock().Now());
  }
  return SendRest(replay);
}

Result<ExitCode> ReplayFile(Context& context, const ReplayWords& words) {
  if (auto allowed = CheckRole(context); !allowed) return allowed.error();
  tendon::os::HoldTerminationSignals();
  const auto client = context.Client();
  if (!client) return client.error();
  auto reader = tendon::mcap::Reader::Open(std::filesystem::path(words.part.file));
  if (!reader) return reader.error();
  auto query = PartQuery(**reader, words.part);
  if (!query) return query.error();
  const std::chrono::duration<double> delay(words.delay);
  // Reading may take long, so a signal must be able to interrupt it.
  std::optional<tendon::os::TerminationUnblockScope> impatient;
  if (context.session() == nullptr) impatient.emplace();
  auto replay =
      Replay::Open(*std::move(reader), *std::move(query),
                   {.rate = words.rate,
                    .loops = words.loops,
                    .as = words.as,
                    .delay = std::chrono::duration_cast<std::chrono::nanoseconds>(
                        std::min<std::chrono::duration<double>>(delay, tendon::kLongestWait))});
  impatient.reset();  // the threads of the processes must not receive the signals
  if (!replay) return replay.error();
  if (auto free = CheckNames((*client)->catalogue(), **replay, words); !free) return free.error();
  const auto started = (*replay)->Start(
      [&](const std::string& name) { return MakeReplayProcess(context, name, words.listen); });
  if (!started) return started.error();
  if (auto joined = (*replay)->WaitUntilJoined(context.settings().timeout); !joined) {
    return joined.error();
  }
  PrintReplayBegin(context, **replay, words);
  const auto begin = tendon::SteadyClock().Now();
  const ReplayEnd end = PlayToTheEnd(**replay);
  const std::chrono::duration<double> passed = tendon::SteadyClock().Now() - begin;
  PrintReplayEnd(context, **replay, words, passed.count());
  if (end == ReplayEnd::kUnsent) {
    context.err() << "gcm: the last rows or events did not reach every viewer, because a viewer "
                     "does not read them\n";
  }
  const auto& problems = (*replay)->reader().problems();
  const ExitCode found = PrintProblems(context, problems.first(), problems.count());
  return end == ReplayEnd::kInterrupted ? program::kInterrupted : found;
}

Verb::Run PrepareReplay(CLI::App& app) {
  auto words = std::make_shared<ReplayWords>();
  AddRecordingFile(app, words->part.file);
  AddRecordingPart(app, words->part);
  app.add_option("--rate", words->rate,
                 "speed of the replay: 2 is twice as fast as recorded, 0.5 half as fast")
      ->type_name("NUMBER")
      ->check(CLI::Range(0.001, 1000.0));
  app.add_flag("--loop", words->loops, "at the end, restart from the beginning, until Ctrl-C");
  app.add_option("--as", words->as, "the name of the process (default: the recorded name)");
  app.add_option("--delay", words->delay,
                 "time before the first row, so that other programs can connect (default: 1s)")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--listen", words->listen,
                 "address at which viewers and other processes connect (default: 127.0.0.1:0)");
  return [words](Context& context) { return ReplayFile(context, *words); };
}

}  // namespace

std::vector<Verb> ReplayVerbs() {
  return {{"replay",
           "replay a recording: the recorded components appear in the running system, but execute "
           "no commands",
           &PrepareReplay,
           {"gcm replay run.mcap", "gcm replay run.mcap --rate 2 --loop --as rehearsal",
            "gcm replay run.mcap --from 10s --to 12s --paths 'robot/arm/**'"}}};
}

}  // namespace console
