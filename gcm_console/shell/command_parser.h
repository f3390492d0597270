#pragma once

#include <tendon/base/result.h>

#include <string>
#include <string_view>
#include <vector>

namespace console {

using Words = std::vector<std::string>;

/// A command to run: its words, and whether it runs in the background.
struct ShellCommand {
  Words words;
  bool is_background = false;

  bool operator==(const ShellCommand&) const = default;
};

/// Splits a line into commands and their words. Blanks separate words; a `gcm` before a verb is
/// skipped. `;` ends a command; `&` ends it and runs it in the background; `#` at the start of a
/// word begins a comment. Inside '...' every character is literal; elsewhere \ makes the next one
/// literal. A word, or the part of a word after =, that begins with { or [ is JSON and ends with
/// its bracket, quotes included. kInvalid if a quote or a bracket is not closed.
tendon::Result<std::vector<ShellCommand>> ParseCommands(std::string_view line);

/// Quotes a word so that ParseCommands() reads it as one.
[[nodiscard]] std::string QuoteWord(std::string_view word);

/// The words of the last command of an unfinished line. The last word is empty after a blank;
/// `typed` is its original text in the line.
struct PartialCommand {
  Words words;
  std::string typed;
};
PartialCommand ParsePartialCommand(std::string_view line);

}  // namespace console
