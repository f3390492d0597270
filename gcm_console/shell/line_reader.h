#pragma once

#include <gcm_console/completion/completer.h>
#include <gcm_console/shell/words.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace console {

/// What a line that is being typed may go on with.
using AskCompletion = std::function<Completion(const Unfinished&)>;

/// Whole lines that are to stand above the prompt, since the last time; nothing where there will be
/// none.
using AskLines = std::function<std::optional<std::string>()>;

/// Where a person types lines.
class LineReader {
 public:
  LineReader() = default;
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  virtual ~LineReader() = default;

  /// The next line; nothing once there are no more.
  virtual std::optional<std::string> Read(const std::string& prompt) = 0;
};

/// Makes one, which keeps what was typed in a file, and prints the lines as they come.
using MakeLineReader = std::unique_ptr<LineReader> (*)(const std::filesystem::path& history,
                                                       AskCompletion completion, AskLines lines);

}  // namespace console
