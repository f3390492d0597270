#include <gcm_console/command_line/word_kind.h>

#include <CLI/CLI.hpp>
#include <array>
#include <string_view>

namespace console {
namespace {

/// The names of the kinds in the help, in the order of the enumerators.
constexpr std::array<std::string_view, 17> kNames = {
    "TEXT",     "FILE",    "VERB",    "PARAMETER", "SETTING", "ARGUMENT",
    "CLASS",    "PLUGIN",  "PROCESS", "COMPONENT", "PATH",    "INTERFACE",
    "PROVIDED", "COMMAND", "VALUE",   "COLUMN",    "EVENT"};

}  // namespace

CLI::Option* WithKind(CLI::Option* option, WordKind kind) {
  return option->type_name(std::string(kNames.at(static_cast<std::size_t>(kind))));
}

WordKind KindOf(const CLI::Option& option) {
  // The type name may also contain a colon, followed by the checks of the option.
  const std::string all = option.get_type_name();
  const std::string name = all.substr(0, all.find(':'));
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames.at(i) == name) return static_cast<WordKind>(i);
  }
  return WordKind::kText;
}

bool IsPath(WordKind kind) { return kind >= WordKind::kProcess; }

bool IsLive(WordKind kind) { return kind >= WordKind::kParameter && !IsPath(kind); }

}  // namespace console
