#pragma once

#include <gcm_console/command_line/shell_session.h>
#include <gcm_console/completion/completer.h>
#include <gcm_console/completion/live_completion.h>
#include <gcm_console/console.h>
#include <gcm_console/shell/command_parser.h>
#include <gcm_console/shell/jobs.h>

#include <optional>
#include <string>
#include <vector>

namespace console {

/// Runs lines of text as commands of `gcm`, for `gcm shell`, `gcm run` and the window's console.
/// Lines omit the word `gcm`; relative paths begin at the path of the last `cd`. For one thread.
class Shell {
 public:
  explicit Shell(Settings settings);

  /// What to do after a command of a line has failed.
  enum class AfterFailure { kGoOn, kStop };

  /// Runs the commands of one line. Returns the exit code of the first that failed, 0 if none did.
  int Run(const std::string& line, const Streams& streams, AfterFailure after);
  /// True after `exit`.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

  /// "robot/arm> ", with the start of relative paths.
  [[nodiscard]] std::string prompt() const;
  /// The completions of a line, from the catalogue as known now. Waits only for words that only a
  /// process knows, such as names of parameters: at most 100 ms, and only until the first reply.
  [[nodiscard]] WordCompletion Complete(const PartialCommand& line);
  /// Takes the complete lines that background jobs have written since the last call; empty if there
  /// are no jobs.
  std::optional<std::string> TakeLines() { return jobs_.TakeLines(); }

 private:
  int RunCommand(const ShellCommand& command, const Streams& streams);
  /// Runs one of the shell's own commands; empty if `words` is not one.
  std::optional<tendon::Result<void>> RunOwnWord(const Words& words, const Streams& streams);
  tendon::Result<void> BeginInBackground(const Words& words, const Streams& streams);
  std::vector<std::string> LiveCompletionsOf(WordKind kind, const Words& before);
  tendon::Result<void> GoTo(const std::string& typed);

  ShellSession session_;
  const Page page_;
  LiveCompletion live_completion_;
  Jobs jobs_;
  bool has_ended_ = false;
};

}  // namespace console
