#pragma once

#include <gcm_console/command_line/word_kind.h>

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace console {

/// The description of one verb, or of `gcm` itself. Help, manual pages and completion are made from
/// this description. It is read from the command-line parser, so that it always agrees with the
/// parser.
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

  std::string name;  ///< the words that the user types: "gcm cert issue"
  std::string summary;
  std::string group;  ///< the group in the list of verbs
  std::vector<Argument> arguments;
  std::vector<Option> options;
  std::vector<std::string> examples;
  std::vector<Page> parts;  ///< verbs of `gcm`, subcommands of `gcm cert`

  /// Returns the part with this name; null if there is none.
  [[nodiscard]] const Page* Find(const std::string& part) const;
  /// Returns the last word of the name: "issue".
  [[nodiscard]] std::string last_word() const;
};

/// Returns the page of a part of the command line. `command` is the name of the parent part, with a
/// blank at the end; empty if there is no parent.
Page PageOf(const CLI::App& app, const std::string& command = "");

/// Returns the usage line: "gcm connect INTERFACE PROVIDED [OPTIONS]".
std::string UsageOf(const Page& page);

}  // namespace console
