#include <gcm_console/line/command_line.h>
#include <gcm_console/place.h>
#include <gcm_console/shell/shell.h>
#include <tendon/base/os/termination.h>

#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Nobody waits longer for a key.
constexpr std::chrono::milliseconds kLongestPause(100);

/// The verbs of `gcm`, and what only makes sense between two lines.
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
  add("cd", "let paths begin there; at the top without a path", {path});
  add("..", "let paths begin one step higher", {});
  add("exit", "end this", {});
  return page;
}

}  // namespace

Shell::Shell(Settings settings)
    : session_(std::move(settings)),
      page_(WithOwnWords(CommandLine({}).page())),
      live_words_(kLongestPause) {
  tendon::os::HoldTerminationSignals();  // also in the threads of the link
  static_cast<void>(session_.Client());
}

int Shell::Run(const std::string& line, const Streams& streams, AfterFailure after) {
  const auto commands = CommandsOf(line);
  if (!commands) {
    streams.err << "gcm: " << Plain(commands.error().message) << '\n';
    return program::kUsage;
  }
  int exit_code = program::kOk;
  for (const Words& words : *commands) {
    // Also what came while a command ran that could not be cut short.
    if (tendon::os::TerminationAsked(std::chrono::milliseconds(0))) {
      tendon::os::HoldTerminationSignals();
      return program::kInterrupted;
    }
    exit_code = RunCommand(words, streams);
    const bool is_interrupted = exit_code == program::kInterrupted;
    if (exit_code != program::kOk && (is_interrupted || after == AfterFailure::kStop)) break;
    if (has_ended_) break;
  }
  return exit_code;
}

int Shell::RunCommand(const Words& words, const Streams& streams) {
  const std::string& verb = words[0];
  if (verb == "exit" || verb == "quit") {
    has_ended_ = true;
    return program::kOk;
  }
  if (verb == "cd" || verb == "..") {
    const std::string typed = verb == ".." ? ".." : words.size() > 1 ? words[1] : "/";
    const auto gone = GoTo(typed);
    if (gone) return program::kOk;
    streams.err << "gcm: " << Plain(gone.error().message) << '\n';
    return program::ExitCodeOf(gone.error().code);
  }
  const int exit_code = RunCommandLine(words, streams, session_);
  tendon::os::HoldTerminationSignals();  // who was told of one lets the next through
  const bool is_help = words == Words{"help"} || words == Words{"--help"};
  if (is_help) streams.out << "Here also: cd PATH, .. and exit; gcm is left out.\n" << std::flush;
  return exit_code;
}

Result<void> Shell::GoTo(const std::string& typed) {
  const std::string path = ResolvedPath(session_.settings().at, typed);
  if (!path.empty()) {
    const auto client = session_.Client();
    if (!client) return client.error();
    if (auto watching = (*client)->WaitUntilWatching(); !watching) return watching;
    const tendon::Catalog catalog = (*client)->catalog();
    const auto place = FindPlace(catalog, path);
    if (!place) return place.error();
    if (place->member != nullptr) {
      return Error{ErrorCode::kInvalid, "nothing is in '" + path + "': go to its interface"};
    }
  }
  session_.GoTo(path);
  return {};
}

std::string Shell::prompt() const {
  const std::string& at = session_.settings().at;
  return (at.empty() ? "gcm" : at) + "> ";
}

std::vector<std::string> Shell::LiveWordsOf(WordKind kind, const Words& before) {
  const auto client = session_.Client();
  return client ? live_words_.Of(**client, kind, before) : Words();
}

Completion Shell::Complete(const Unfinished& line) {
  return console::Complete(
      page_, line.words,
      {.catalog = [this] { return session_.catalog(); },
       .words = [this](WordKind kind, const Words& before) { return LiveWordsOf(kind, before); }},
      session_.settings().at);
}

}  // namespace console
