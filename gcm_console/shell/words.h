#pragma once

#include <tendon/base/result.h>

#include <string>
#include <string_view>
#include <vector>

namespace console {

using Words = std::vector<std::string>;

/// What is to be run: its words, and whether the prompt comes back before it has ended.
struct Command {
  Words words;
  bool is_behind = false;

  bool operator==(const Command&) const = default;
};

/// The commands of a line: their words, those between blanks; a `gcm` before a verb is passed over.
/// `;` ends a command, `&` too, which leaves it behind the prompt; `#` where a word would begin
/// ends the line. Between '...' a letter is only a letter, between "..." and elsewhere \ makes it
/// one. A word that begins with { or [ is JSON and ends with its bracket, quotes and all; so is
/// what follows a = in a word. kInvalid where a quote or a bracket has no end.
tendon::Result<std::vector<Command>> CommandsOf(std::string_view line);

/// A word as it is to be typed, so that CommandsOf() reads it as one.
[[nodiscard]] std::string Quoted(std::string_view word);

/// The words of the last command of a line that is being typed; the last one, of which `typed` are
/// the letters as they stand in the line, is empty behind a blank.
struct Unfinished {
  Words words;
  std::string typed;
};
Unfinished UnfinishedOf(std::string_view line);

}  // namespace console
