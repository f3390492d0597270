#include <gcm_console/command_line/input_lines.h>
#include <gcm_console/shell/shell.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <utility>

namespace console {
namespace {

namespace fs = std::filesystem;

/// Returns the file with the lines that were typed in earlier shells.
fs::path HistoryFile() {
  const fs::path folder = tendon::os::StateFolder().parent_path() / "gcm";
  std::error_code none;
  fs::create_directories(folder, none);
  fs::permissions(folder, fs::perms::owner_all, none);
  return folder / "history";
}

ExitCode TypeLines(Shell& shell, const Streams& streams) {
  const auto reader = streams.make_line_reader(
      HistoryFile(), [&shell](const PartialCommand& line) { return shell.Complete(line); },
      [&shell] { return shell.TakeLines(); });
  int exit_code = program::kOk;
  while (!shell.has_ended()) {
    const auto line = reader->Read(shell.prompt());
    if (!line) {
      streams.out << '\n';
      break;
    }
    exit_code = shell.Run(*line, streams, tendon::AfterError::kGoOn);
  }
  return static_cast<ExitCode>(exit_code);
}

Result<ExitCode> ReadLines(Shell& shell, const Streams& streams) {
  int exit_code = program::kOk;
  InputLines lines(std::cin);
  for (std::string line;
       !shell.has_ended() && exit_code != program::kInterrupted && lines.Next(line);) {
    exit_code = shell.Run(line, streams, tendon::AfterError::kGoOn);
  }
  if (lines.error()) return *lines.error();
  return static_cast<ExitCode>(exit_code);
}

Result<ExitCode> RunShell(Context& context) {
  if (context.session() != nullptr) {
    return Error{ErrorCode::kInvalid, "this is already gcm shell; to leave gcm shell: exit"};
  }
  Shell shell(context.settings());
  const bool is_typed = context.streams().make_line_reader != nullptr;
  if (is_typed) return TypeLines(shell, context.streams());
  return ReadLines(shell, context.streams());
}

constexpr int kMaxScripts = 10;

struct ScriptOptions {
  std::string file;
  bool keeps_going = false;
};

Result<ExitCode> RunLines(Context& context, const ScriptOptions& options, std::istream& script) {
  const std::string name = options.file == "-" ? "standard input" : options.file;
  Settings settings = context.settings();
  if (++settings.scripts > kMaxScripts) {
    return Error{ErrorCode::kInvalid, "scripts are nested more than " +
                                          std::to_string(kMaxScripts) +
                                          " deep: check whether a script runs itself"};
  }
  Shell shell(std::move(settings));
  int failure = program::kOk;
  int number = 0;
  InputLines lines(script);
  for (std::string line; !shell.has_ended() && lines.Next(line);) {
    ++number;
    const int exit_code =
        shell.Run(line, context.streams(),
                  options.keeps_going ? tendon::AfterError::kGoOn : tendon::AfterError::kStop);
    if (exit_code == program::kOk) continue;
    const bool stops = !options.keeps_going || exit_code == program::kInterrupted;
    context.err() << "gcm: " << Plain(name) << ", line " << number << ": failed with exit code "
                  << exit_code << (stops ? "; the following lines were not executed" : "") << '\n';
    if (failure == program::kOk || stops) failure = exit_code;
    if (stops) break;
  }
  if (lines.error()) {
    return Error{lines.error()->code,
                 name + ", after line " + std::to_string(number) + ": " + lines.error()->message};
  }
  return static_cast<ExitCode>(failure);
}

Result<ExitCode> RunScript(Context& context, const ScriptOptions& options) {
  if (options.file == "-" && !context.streams().has_input) return NoInput("run");
  if (options.file == "-") return RunLines(context, options, std::cin);
  std::error_code none;
  if (fs::is_directory(options.file, none)) {
    return Error{ErrorCode::kInvalid,
                 options.file + " is a folder: give a file with one gcm command in each line"};
  }
  std::ifstream script(options.file);
  if (!script) {
    return Error{
        ErrorCode::kNotFound,
        "cannot read " + tendon::Printable(options.file) +
            (fs::exists(options.file, none) ? ": not allowed" : ": there is no such file")};
  }
  return RunLines(context, options, script);
}

Verb::Run PrepareScript(CLI::App& app) {
  auto options = std::make_shared<ScriptOptions>();
  WithKind(app.add_option(
               "file", options->file,
               "file with one command in each line, as in gcm shell; - reads the lines from stdin"),
           WordKind::kFile)
      ->required();
  app.add_flag("--keep-going", options->keeps_going, "continue after a line that has failed");
  return [options](Context& context) { return RunScript(context, *options); };
}

}  // namespace

std::vector<Verb> ShellVerbs() {
  return {
      {"shell", "start a prompt for verbs, with completion, history and cd; see: gcm help prompt",
       [](CLI::App&) -> Verb::Run { return &RunShell; }},
      {"run",
       "execute the verbs in a file, and stop at the first verb that fails",
       &PrepareScript,
       {"gcm run start.gcm", "gcm run --keep-going -"}},
  };
}

}  // namespace console
