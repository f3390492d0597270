#include <gcm_console/command_line/command_line.h>

#include <gcm_console/catalogue/glob.h>
#include <gcm_console/output/table.h>
#include <program/command_line.h>
#include <program/network_options.h>
#include <tendon/base/name.h>
#include <tendon/base/text.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Returns the command whose help the error suggests: `gcm`, followed by the verb if one was given.
std::string HelpCommand(const CLI::App& app) {
  std::string command = app.get_name();
  for (const CLI::App* verb : app.get_subcommands()) command += " " + HelpCommand(*verb);
  return command;
}

std::vector<std::string> VerbsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

/// Returns the option for a word such as "--gcm", declared by the part or one of its parents; null
/// if there is none.
const CLI::Option* OptionOf(const CLI::App* part, const std::string& word) {
  for (; part != nullptr; part = part->get_parent()) {
    if (const CLI::Option* option = part->get_option_no_throw(word)) return option;
  }
  return nullptr;
}

/// Returns true for "-inf", "-Infinity" and "-NaN".
bool IsNegativeName(const std::string& word) {
  const std::string name = tendon::InLowerCase(word);
  return name == "-inf" || name == "-infinity" || name == "-nan";
}

/// Protects a word from CLI11. CLI11 would split a word in brackets if an option accepts several
/// words, and it would read "-inf" as options of one letter. A blank at the beginning or at the end
/// of the word prevents this. AsTyped() removes the blank.
std::string KeptWhole(const std::string& word) {
  const bool is_in_brackets = word.starts_with('[') && word.ends_with(']');
  if (is_in_brackets || word.ends_with(' ')) return word + ' ';
  return IsNegativeName(word) || word.starts_with(' ') ? ' ' + word : word;
}

std::string AsTyped(std::string& word) {
  if (word.ends_with(' ')) {
    word.pop_back();
  } else if (word.starts_with(' ')) {
    word.erase(0, 1);
  }
  return {};
}

/// Restores the words as typed. Must be added before all other transformations.
void TakeAsTyped(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const bool is_flag = option->get_items_expected_max() == 0;
    if (!is_flag) option->transform(CLI::Validator(&AsTyped, ""));
  }
  for (CLI::App* part : app.get_subcommands([](CLI::App* /*part*/) { return true; })) {
    TakeAsTyped(*part);
  }
}

/// Returns an error such as "no verb 'conect'; did you mean 'connect'? to list the verbs: gcm
/// --help". The error is about the first word that is neither an option nor the value of an option.
/// Empty if this word is a verb, or follows an unknown option.
std::string UnknownVerb(const std::vector<std::string>& words, const CLI::App& app) {
  const CLI::App* part = &app;
  std::string command = app.get_name();
  for (std::size_t i = 0; i < words.size() && part->get_require_subcommand_min() > 0; ++i) {
    if (words[i].starts_with('-')) {
      const std::size_t value = words[i].find('=');
      const CLI::Option* option = OptionOf(part, words[i].substr(0, value));
      if (option == nullptr) return "";
      if (value == std::string::npos && option->get_expected_min() > 0) ++i;
      continue;
    }
    const auto named =
        part->get_subcommands([&](const CLI::App* verb) { return verb->get_name() == words[i]; });
    if (named.empty()) {
      const std::string near = tendon::DidYouMean(words[i], VerbsOf(*part));
      return "no verb '" + words[i] + "'" + near + (near.empty() ? "; " : " ") +
             "to list the verbs: " + command + " --help";
    }
    part = named[0];
    command += " " + words[i];
  }
  return "";
}

/// Returns "--gcm needs a value" for the first option that ends with '=', for example because a
/// variable is not set. Without this check, CLI11 would take the next word as the value. Empty if
/// there is no such option.
std::string EmptyValue(const std::vector<std::string>& words, const CLI::App& app) {
  const CLI::App* part = &app;
  for (const std::string& word : words) {
    if (word == "--") break;  // all words after "--" are arguments, not options
    if (word.starts_with("--") && word.ends_with('=')) {
      const std::string name = word.substr(0, word.size() - 1);
      const CLI::Option* option = OptionOf(part, name);
      if (option != nullptr && option->get_expected_min() > 0) return name + " needs a value";
    }
    const auto named =
        part->get_subcommands([&](const CLI::App* verb) { return verb->get_name() == word; });
    if (!named.empty()) part = named[0];
  }
  return "";
}

/// Returns "--long is given 2 times" for a repeated flag. CLI11 itself counts only options with a
/// value.
std::string RepeatedFlag(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options()) {
    const bool is_flag = option->get_items_expected_max() == 0;
    if (is_flag && option->count() > 1) {
      return option->get_name() + " is given " + std::to_string(option->count()) + " times";
    }
  }
  for (const CLI::App* part : app.get_subcommands()) {
    if (std::string repeated = RepeatedFlag(*part); !repeated.empty()) return repeated;
  }
  return "";
}

/// Refuses a glob for a verb that accepts only one name. The usual check would only say that '*' is
/// not allowed in a name.
Result<void> CheckGlobs(const CLI::App& app) {
  static const std::set<std::string> kTakeOne = {"call",    "candidates", "classes", "create",
                                                 "explain", "hz",         "load"};
  for (const CLI::App* verb : app.get_subcommands()) {
    if (!kTakeOne.contains(verb->get_name())) continue;
    for (const CLI::Option* option : verb->get_options()) {
      if (!IsPath(KindOf(*option))) continue;
      for (const std::string& path : option->results()) {
        if (IsGlob(path)) return NoGlobAllowed("gcm " + verb->get_name(), path);
      }
    }
  }
  return {};
}

const std::map<std::string, ColorChoice>& Colors() {
  static const std::map<std::string, ColorChoice> kColors = {{"auto", ColorChoice::kAuto},
                                                             {"always", ColorChoice::kAlways},
                                                             {"never", ColorChoice::kNever}};
  return kColors;
}

}  // namespace

CommandLine::CommandLine(Settings usual, Complement complement)
    : settings_(std::move(usual)), complement_(std::move(complement)) {
  app_.require_subcommand(1);
  app_.fallthrough();
  AddSettings();
  for (const Verb& verb : AllVerbs()) AddVerb(verb);
  TakeAsTyped(app_);
}

void CommandLine::AddSettings() {
  app_.set_help_flag("-h,--help", "print the list of verbs, or the help of one verb");
  app_.set_version_flag("--version", VersionLine(), "print the version of gcm");
  program::AddGcmOption(app_, settings_.gcm);
  timeout_ms_ = static_cast<int>(settings_.timeout.count());
  app_.add_option(
          "--timeout", timeout_ms_,
          "maximum time to wait for a reply: 500ms, 5s, 2min or a number of ms (default: 2s)")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformMilliseconds, ""));
  app_.add_flag("--json,--jsonl", settings_.json,
                "print JSON: one document, or one document for each row");
  app_.add_flag("--no-header", has_no_titles_, "print tables on a terminal without column titles");
  for (const auto& [name, choice] : Colors()) {
    if (choice == settings_.color) color_ = name;
  }
  app_.add_option("--color", color_, "when to use colours")
      ->check(CLI::IsMember(Colors()))
      ->capture_default_str();
  auto* quiet = app_.add_flag("-q,--quiet", is_quiet_, "print only results and errors");
  app_.add_flag("-v,--verbose", is_verbose_,
                "print the address of the GCM, and how fast the GCM answers")
      ->excludes(quiet);
  app_.add_flag("--read-only", settings_.read_only,
                "connect with the role viewer, which cannot change anything");
  program::AddNetworkOptions(app_, settings_.network);
}

void CommandLine::AddVerb(const Verb& verb) {
  CLI::App* part = app_.add_subcommand(verb.name, verb.summary);
  part->group(verb.group);
  part->fallthrough();
  std::string examples;
  for (const std::string& example : verb.examples) examples += example + "\n";
  part->footer(examples);
  part->callback([this, runner = verb.prepare(*part), name = verb.name] {
    run_ = runner;
    verb_ = name;
  });
  if (settings_.in_session) Resolve(*part);
}

/// Makes the paths of the verb's options absolute. Relative paths are relative to `at`.
void CommandLine::Resolve(CLI::App& part) const {
  for (CLI::Option* option : part.get_options()) {
    if (!IsPath(KindOf(*option))) continue;
    option->transform(CLI::Validator(
        [this, kind = KindOf(*option)](std::string& typed) {
          typed = complement_ ? complement_(kind, typed) : ResolvedPath(settings_.at, typed);
          return std::string();
        },
        ""));
  }
}

Result<void> CommandLine::Parse(const std::vector<std::string>& words) {
  if (const std::string unknown = UnknownVerb(words, app_); !unknown.empty()) {
    return Error{ErrorCode::kInvalid, unknown};
  }
  const auto mistaken = [this](const std::string& mistake) {
    return Error{ErrorCode::kInvalid, mistake + "; " + HelpCommand(app_) + " --help tells more"};
  };
  if (const std::string empty = EmptyValue(words, app_); !empty.empty()) return mistaken(empty);
  try {
    std::vector<std::string> whole(words.rbegin(), words.rend());
    std::ranges::transform(whole, whole.begin(), KeptWhole);
    app_.parse(std::move(whole));
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::ParseError& mistake) {
    return Error{ErrorCode::kInvalid, program::SentenceOf(mistake, app_, HelpCommand(app_))};
  }
  if (const std::string flag = RepeatedFlag(app_); !flag.empty()) return mistaken(flag);
  if (auto good = CheckGlobs(app_); !good) return good;
  settings_.gcm = program::GcmAddress(settings_.gcm);
  settings_.timeout = std::chrono::milliseconds(timeout_ms_);
  settings_.color = Colors().at(color_);
  if (has_no_titles_) settings_.titles = false;
  if (is_quiet_) settings_.verbosity = Verbosity::kQuiet;
  if (is_verbose_) settings_.verbosity = Verbosity::kVerbose;
  return {};
}

Page CommandLine::chosen_page() const {
  const Page all = page();
  const Page* chosen = &all;
  for (const CLI::App* part = &app_; !part->get_subcommands().empty();) {
    part = part->get_subcommands().front();
    if (const Page* found = chosen->Find(part->get_name())) chosen = found;
  }
  return *chosen;
}

std::string ResolvedPath(const std::string& at, const std::string& typed) {
  const bool is_from_top = typed.starts_with('/');
  std::vector<std::string> parts;
  for (const std::string& text : {is_from_top ? std::string() : at, typed}) {
    std::istringstream all(text);
    for (std::string part; std::getline(all, part, '/');) {
      if (part == "..") {
        if (!parts.empty()) parts.pop_back();
      } else if (!part.empty() && part != ".") {
        parts.push_back(part);
      }
    }
  }
  constexpr std::size_t kInterface = 3;  // after the interface, a dot separates the member
  std::string path;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    path += (i == 0 ? "" : i == kInterface ? "." : "/") + parts[i];
  }
  return path;
}

std::string VersionLine() { return std::string("gcm ") + TENDON_VERSION; }

}  // namespace console
