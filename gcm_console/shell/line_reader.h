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

/// Returns the complete lines since the last call, to print above the prompt; empty if there will
/// be no more.
using AskLines = std::function<std::optional<std::string>()>;

/// The source of the lines that a person types.
class LineReader {
 public:
  LineReader() = default;
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;
  virtual ~LineReader() = default;

  /// Reads the next line; empty at the end of the input.
  virtual std::optional<std::string> Read(const std::string& prompt) = 0;
};

/// Creates a reader that keeps its history in a file and prints lines from `lines` as they arrive.
using MakeLineReader = std::unique_ptr<LineReader> (*)(const std::filesystem::path& history,
                                                       AskCompletion completion, AskLines lines);

}  // namespace console
