#pragma once

#include <gcm_console/line/word_kind.h>

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace console {

/// All there is to say of one verb, or of `gcm` itself: what help, manual and completion are made
/// from. It is read off the command line that the program itself understands.
struct Page {
  /// A word that is recognised by where it stands.
  struct Argument {
    std::string name;
    std::string help;
    WordKind kind = WordKind::kText;
    std::vector<std::string> choices;  ///< where there are only these
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

  std::string name;  ///< as it is typed: "gcm cert issue"
  std::string summary;
  std::string group;  ///< of the verbs among which it is listed
  std::vector<Argument> arguments;
  std::vector<Option> options;
  std::vector<std::string> examples;
  std::vector<Page> parts;  ///< verbs of `gcm`, acts of `gcm cert`

  /// The part of that name; null where there is none.
  [[nodiscard]] const Page* Find(const std::string& part) const;
  /// Without what it is a part of: "issue".
  [[nodiscard]] std::string last_word() const;
};

/// The page of a part of a command line. `command` is what it is a part of, with a blank behind, or
/// empty.
Page PageOf(const CLI::App& app, const std::string& command = "");

/// "gcm connect INTERFACE PROVIDED [OPTIONS]".
std::string UsageOf(const Page& page);

}  // namespace console
