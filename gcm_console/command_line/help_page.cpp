#include <gcm_console/command_line/help_page.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <sstream>

namespace console {
namespace {

std::string Upper(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::toupper(letter));
  return text;
}

/// Returns the choices of an option: both words of "TEXT:{debug,info}".
std::vector<std::string> ChoicesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const auto begin = type.find('{');
  const auto end = type.find('}');
  std::vector<std::string> choices;
  if (begin == type.npos || end == type.npos) return choices;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  return choices;
}

std::string ValueOf(const CLI::Option& option) {
  if (option.get_expected_min() == 0) return "";
  const std::string type = option.get_type_name();
  const std::string name = type.substr(0, type.find(':'));
  if (name == "UINT" || name == "INT" || name == "FLOAT") return "NUMBER";
  return name;
}

std::string HelpOf(const CLI::Option& option) {
  const std::string usual = option.get_default_str();
  return option.get_description() + (usual.empty() ? "" : " (default: " + usual + ")");
}

Page::Argument PageArgumentOf(const CLI::Option& option) {
  return {.name = option.get_name(true),
          .help = HelpOf(option),
          .kind = KindOf(option),
          .choices = ChoicesOf(option),
          .is_required = option.get_required(),
          .is_many = option.get_items_expected_max() > 1};
}

Page::Option OptionOf(const CLI::Option& option) {
  Page::Option found{.names = {},
                     .value = ValueOf(option),
                     .help = HelpOf(option),
                     .kind = KindOf(option),
                     .choices = ChoicesOf(option)};
  for (const std::string& name : option.get_snames()) found.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) found.names.push_back("--" + name);
  return found;
}

}  // namespace

const Page* Page::Find(const std::string& part) const {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const Page& one) { return one.last_word() == part; });
  return found == parts.end() ? nullptr : &*found;
}

std::string Page::last_word() const { return name.substr(name.rfind(' ') + 1); }

Page PageOf(const CLI::App& app, const std::string& command) {
  Page page{.name = command + app.get_name(),
            .summary = app.get_description(),
            .group = app.get_group(),
            .arguments = {},
            .options = {},
            .examples = {},
            .parts = {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      page.arguments.push_back(PageArgumentOf(*option));
    } else if (option != app.get_help_ptr() || command.empty()) {
      page.options.push_back(OptionOf(*option));
    }
  }
  std::istringstream examples(app.get_footer());
  for (std::string line; std::getline(examples, line);) page.examples.push_back(line);
  for (const CLI::App* part : app.get_subcommands({})) {
    page.parts.push_back(PageOf(*part, page.name + " "));
  }
  return page;
}

std::string UsageOf(const Page& page) {
  std::string usage = page.name;
  if (page.parts.size() > 1) usage += " VERB ...";
  for (const auto& argument : page.arguments) {
    const std::string word = Upper(argument.name) + (argument.is_many ? "..." : "");
    usage += argument.is_required ? " " + word : " [" + word + "]";
  }
  return usage + (page.options.empty() ? "" : " [OPTIONS]");
}

}  // namespace console
