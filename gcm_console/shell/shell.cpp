#include <gcm_console/shell/shell.h>

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/command_line/command_line.h>
#include <gcm_console/completion/path_completion.h>
#include <tendon/base/os/termination.h>

#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// The maximum time that the user waits after pressing Tab.
constexpr std::chrono::milliseconds kLongestPause(100);

/// Adds the commands of the shell itself, such as `cd`, to the verbs of `gcm`.
Page WithOwnWords(Page page) {
  using Arguments = std::vector<Page::Argument>;
  const auto add = [&](const std::string& name, const std::string& summary,
                       const Arguments& arguments) {
    page.parts.push_back(
        {.name = name, .summary = summary, .group = "shell", .arguments = arguments});
  };
  Page::Argument path;
  path.name = "path";
  path.kind = WordKind::kPath;
  add("cd", "make paths relative to PATH; without PATH, return to the top", {path});
  add("..", "go one level up", {});
  Page::Argument number;
  number.name = "number";
  add("jobs", "list the background jobs that were started with &", {});
  add("end", "end one background job, or all of them without a number", {number});
  add("exit", "end this session", {});
  return page;
}

/// Prepares the next command after a signal: holds termination signals again, and clears the errors
/// of the streams.
void GoOn(const Streams& streams) {
  tendon::os::HoldTerminationSignals();
  streams.out.clear();
  streams.err.clear();
}

}  // namespace

Shell::Shell(Settings settings)
    : session_(std::move(settings)),
      page_(WithOwnWords(CommandLine({}).page())),
      live_completion_(kLongestPause) {
  tendon::os::HoldTerminationSignals();  // must be called before the threads of the link start
  static_cast<void>(session_.Client());
}

int Shell::Run(const std::string& line, const Streams& streams, tendon::AfterError after_error) {
  const auto commands = ParseCommands(line);
  if (!commands) {
    streams.err << "gcm: " << Plain(commands.error().message) << '\n';
    return program::kUsage;
  }
  int failure = program::kOk;
  for (const ShellCommand& command : *commands) {
    // A signal may also have arrived during a command that could not be interrupted.
    if (tendon::os::TerminationRequested(std::chrono::milliseconds(0))) {
      GoOn(streams);
      return program::kInterrupted;
    }
    const int exit_code = RunCommand(command, streams);
    GoOn(streams);  // a command that gets a signal releases the held signals
    const bool is_interrupted = exit_code == program::kInterrupted;
    if (failure == program::kOk || is_interrupted) failure = exit_code;
    const bool is_stop = is_interrupted || after_error == tendon::AfterError::kStop;
    if (exit_code != program::kOk && is_stop) break;
    if (has_ended_) break;
  }
  return failure;
}

int Shell::RunCommand(const ShellCommand& command, const Streams& streams) {
  const Words& words = command.words;
  const std::optional<Result<void>> own =
      command.is_background ? BeginInBackground(words, streams) : RunOwnWord(words, streams);
  if (own && *own) return program::kOk;
  if (own) {
    streams.err << "gcm: " << Plain(own->error().message) << '\n';
    return program::ExitCodeOf(own->error().code);
  }
  const int exit_code = RunCommandLine(words, streams, session_);
  const bool is_help = words == Words{"help"} || words == Words{"--help"};
  if (is_help) {
    streams.out << "Also available here: cd PATH, .., jobs, end and exit; see: help prompt.\n"
                << std::flush;
  }
  return exit_code;
}

std::optional<Result<void>> Shell::RunOwnWord(const Words& words, const Streams& streams) {
  const std::string& word = words[0];
  const bool is_alone = words.size() == 1;
  if (word == "cd" || word == "..") return GoTo(word == ".." ? ".." : is_alone ? "/" : words[1]);
  if (word == "jobs") {
    jobs_.Print(streams.out);
  } else if (word == "end" && !is_alone) {
    return jobs_.End(words[1]);
  } else if (word == "end") {
    jobs_.EndAll();
  } else if (word == "exit" || word == "quit") {
    has_ended_ = true;
  } else {
    return std::nullopt;
  }
  return Result<void>();
}

Result<void> Shell::BeginInBackground(const Words& words, const Streams& streams) {
  if (streams.make_line_reader == nullptr || session_.settings().scripts > 0) {
    return Error{ErrorCode::kInvalid, "& can be used only at the prompt of gcm shell"};
  }
  return jobs_.Begin(words, session_.settings(), streams.columns);
}

Result<void> Shell::GoTo(const std::string& typed) {
  std::string path = ResolvedPath(session_.settings().at, typed);
  if (!path.empty()) {
    const auto client = session_.Client();
    if (!client) return client.error();
    if (auto watching = (*client)->WaitUntilWatching(); !watching) return watching;
    const tendon::Catalogue catalogue = (*client)->catalogue();
    path = WholePath(catalogue, WordKind::kPath,
                     PathFrom(catalogue, session_.settings().at, typed + "/"));
    const auto target = FindTarget(catalogue, path);
    if (!target) return target.error();
    if (target->member != nullptr) {
      return Error{ErrorCode::kInvalid,
                   "'" + path + "' contains nothing: use cd with its interface"};
    }
  }
  session_.GoTo(path);
  return {};
}

std::string Shell::prompt() const {
  const std::string& at = session_.settings().at;
  return (at.empty() ? "gcm" : at) + "> ";
}

std::vector<std::string> Shell::LiveCompletionsOf(WordKind kind, const Words& before) {
  const auto client = session_.Client();
  return client ? live_completion_.Of(**client, kind, before) : Words();
}

WordCompletion Shell::Complete(const PartialCommand& line) {
  return console::Complete(
      page_, line.words,
      {.catalogue = [this] { return session_.catalogue(); },
       .words = [this](WordKind kind,
                       const Words& before) { return LiveCompletionsOf(kind, before); }},
      session_.settings().at);
}

}  // namespace console
