#pragma once

#include <gcm_console/completion/completer.h>
#include <gcm_console/shell/command_parser.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace console {

/// Returns the completions of an unfinished line.
using AskCompletion = std::function<WordCompletion(const PartialCommand&)>;

/// Returns the complete lines since the last call; they are printed above the prompt. Returns no
/// value if there will be no more lines.
using AskLines = std::function<std::optional<std::string>()>;

/// Reads the lines that a person types.
class LineReader {
 public:
  LineReader() = default;
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  virtual ~LineReader() = default;

  /// Reads the next line; returns no value at the end of the input.
  virtual std::optional<std::string> Read(const std::string& prompt) = 0;
};

/// Makes a reader that keeps its history in a file, and prints the lines of `lines` when they
/// arrive.
using MakeLineReader = std::unique_ptr<LineReader> (*)(const std::filesystem::path& history,
                                                       AskCompletion completion, AskLines lines);

}  // namespace console
