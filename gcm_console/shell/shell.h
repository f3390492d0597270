#pragma once

#include <gcm_console/completion/completer.h>
#include <gcm_console/completion/live_words.h>
#include <gcm_console/console.h>
#include <gcm_console/line/session.h>
#include <gcm_console/shell/jobs.h>
#include <gcm_console/shell/words.h>

#include <optional>
#include <string>
#include <vector>

namespace console {

/// Lines of text as commands of `gcm`, without that word: what `gcm shell`, `gcm run` and the
/// window's console have in common. Paths begin where the last `cd` went. Used by one thread.
class Shell {
 public:
  explicit Shell(Settings settings);

  /// What is to be done once a command of a line has failed.
  enum class AfterFailure { kGoOn, kStop };

  /// Runs the commands of one line; the exit code of the first that failed, 0 where none did.
  int Run(const std::string& line, const Streams& streams, AfterFailure after);
  /// Somebody has typed `exit`.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

  /// "robot/arm> ", by where paths begin.
  [[nodiscard]] std::string prompt() const;
  /// What a line may go on with, from the catalogue as it is known at this moment. Waits for
  /// nothing but what only a process knows, as the names of parameters: 100 ms at most, and only
  /// until it has said it once.
  [[nodiscard]] Completion Complete(const Unfinished& line);
  /// What the commands behind the prompt have said since the last time, in whole lines; nothing
  /// where there are none.
  std::optional<std::string> TakeLines() { return jobs_.TakeLines(); }

 private:
  int RunCommand(const Command& command, const Streams& streams);
  /// Of those that only make sense between two lines; nothing where it is none of them.
  std::optional<tendon::Result<void>> RunOwnWord(const Words& words, const Streams& streams);
  tendon::Result<void> BeginBehind(const Words& words, const Streams& streams);
  std::vector<std::string> LiveWordsOf(WordKind kind, const Words& before);
  tendon::Result<void> GoTo(const std::string& typed);

  Session session_;
  const Page page_;
  LiveWords live_words_;
  Jobs jobs_;
  bool has_ended_ = false;
};

}  // namespace console
