#pragma once

#include <tendon/base/result.h>

#include <string>
#include <string_view>
#include <vector>

namespace console {

using Words = std::vector<std::string>;

/// A command to run: its words, and whether it must run in the background.
struct ShellCommand {
  Words words;
  bool is_background = false;

  bool operator==(const ShellCommand&) const = default;
};

/// Splits a line into commands, and each command into words. Blanks separate words. A `gcm` before
/// a verb is skipped. `;` ends a command; `&` ends a command that must run in the background; `#`
/// at the beginning of a word begins a comment. Inside '...' every character is literal; elsewhere,
/// `\` makes the next character literal. A word that begins with { or [ is JSON, and so is the part
/// after `=` if it begins so: JSON ends with the closing bracket and keeps its quotes. Returns
/// kInvalid if a quote or a bracket is not closed.
tendon::Result<std::vector<ShellCommand>> ParseCommands(std::string_view line);

/// Quotes a word so that ParseCommands() reads it as one word.
[[nodiscard]] std::string QuoteWord(std::string_view word);

/// The words of the last command in an unfinished line. The last word is empty if the line ends
/// with a blank. `typed` is the last word as it was typed.
struct PartialCommand {
  Words words;
  std::string typed;
};
PartialCommand ParsePartialCommand(std::string_view line);

}  // namespace console
