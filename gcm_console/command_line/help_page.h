#pragma once

#include <gcm_console/command_line/word_kind.h>

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace console {

/// The description of one verb, or of `gcm` itself: the source of help, manual and completion. It
/// is read from the command-line parser itself, so the two always agree.
struct Page {
  /// A positional argument.
  struct Argument {
    std::string name;
    std::string help;
    WordKind kind = WordKind::kText;
    std::vector<std::string> choices;  ///< the allowed values; empty if any value is allowed
    bool is_required = false;
    bool is_many = false;
  };
  struct Option {
    std::vector<std::string> names;  ///< "-f", "--follow"
    std::string value;               ///< "NUMBER"; empty for a flag
    std::string help;
    WordKind kind = WordKind::kText;
    std::vector<std::string> choices;
  };

  std::string name;  ///< as typed: "gcm cert issue"
  std::string summary;
  std::string group;  ///< the group in the list of verbs
  std::vector<Argument> arguments;
  std::vector<Option> options;
  std::vector<std::string> examples;
  std::vector<Page> parts;  ///< verbs of `gcm`, subcommands of `gcm cert`

  /// The part with this name; null if there is none.
  [[nodiscard]] const Page* Find(const std::string& part) const;
  /// The last part of the name: "issue".
  [[nodiscard]] std::string last_word() const;
};

/// The page of a part of a command line. `command` is the name of its parent with a trailing blank,
/// or empty.
Page PageOf(const CLI::App& app, const std::string& command = "");

/// "gcm connect INTERFACE PROVIDED [OPTIONS]".
std::string UsageOf(const Page& page);

}  // namespace console
