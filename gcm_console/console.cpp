#include <gcm_console/console.h>
#include <gcm_console/report.h>
#include <gcm_console/verb.h>
#include <program/command_line.h>
#include <program/network_options.h>
#include <tendon/base/name.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <exception>
#include <ostream>

namespace console {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 done, 1 refused or failed, 2 usage, 3 no GCM, 4 not found, 5 incompatible,\n"
    "6 time-out (outcome unknown), 7 denied, 130 interrupted.";

/// What to ask for help: the verb, if one was given.
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

/// What a word like "--gcm" names, in a part or in what that is a part of; null where it is
/// nothing.
const CLI::Option* OptionOf(const CLI::App* part, const std::string& word) {
  for (; part != nullptr; part = part->get_parent()) {
    if (const CLI::Option* option = part->get_option_no_throw(word)) return option;
  }
  return nullptr;
}

/// "no verb 'conect'; did you mean 'connect'? gcm --help lists them", for the first word where a
/// verb is expected, which is no option nor an option's value; nothing where it is one, or where an
/// unknown option comes first.
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
      return "no verb '" + Plain(words[i]) + "'" + near + (near.empty() ? "; " : " ") + command +
             " --help lists them";
    }
    part = named[0];
    command += " " + words[i];
  }
  return "";
}

void AddSettings(CLI::App& app, Settings& settings, int& timeout_ms) {
  app.add_option("--gcm", settings.gcm,
                 "address of the GCM (default: $TENDON_GCM, 127.0.0.1:10705)");
  app.add_option("--timeout", timeout_ms, "how long an answer may take, in ms")
      ->check(CLI::Range(1, 3600000))
      ->capture_default_str();
  app.add_flag("--json,--jsonl", settings.json, "print JSON: one document, or one a row");
  app.add_flag("--read-only", settings.read_only, "ask as a viewer, to whom changes are denied");
  program::AddNetworkOptions(app, settings.network);
}

/// `gcm help VERB` is `gcm VERB --help`, `gcm help` is `gcm --help`.
std::vector<std::string> WithoutHelpVerb(std::vector<std::string> words) {
  if (words.empty() || words[0] != "help") return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

/// The named verb ran, or why it did not.
int Finish(const tendon::Result<program::ExitCode>& result, std::ostream& out, std::ostream& err) {
  const bool is_written = static_cast<bool>(out.flush());
  const bool is_left = errno == EPIPE;  // whoever reads has enough, as `head` after ten lines
  if (!result) {
    err << "gcm: " << Plain(result.error().message) << '\n';
    return program::ExitCodeOf(result.error().code);
  }
  if (!is_written) {
    if (!is_left) err << "gcm: cannot write the output: the disk is full, or it is closed\n";
    return program::kRefused;
  }
  return *result;
}

}  // namespace

std::vector<Verb> AllVerbs() {
  std::vector<Verb> all;
  for (auto* group : {&LookVerbs, &DataVerbs, &ActVerbs, &WireVerbs, &ExplainVerbs, &LogVerbs,
                      &CertVerbs, &ServeVerbs}) {
    auto verbs = group();
    std::move(verbs.begin(), verbs.end(), std::back_inserter(all));
  }
  return all;
}

int RunCommandLine(const std::vector<std::string>& typed, std::ostream& out, std::ostream& err,
                   int columns) {
  if (typed == std::vector<std::string>{"help", "exit-codes"}) {
    out << kExitCodes << '\n';
    return Finish(program::kOk, out, err);
  }
  const std::vector<std::string> words = WithoutHelpVerb(typed);
  Settings settings;
  int timeout_ms = static_cast<int>(settings.timeout.count());
  CLI::App app("Sees and steers a system of components through its GCM.", "gcm");
  app.require_subcommand(1);
  app.fallthrough();
  app.footer(kExitCodes);
  AddSettings(app, settings, timeout_ms);

  std::string chosen;
  Verb::Run run;
  for (const Verb& verb : AllVerbs()) {
    CLI::App* part = app.add_subcommand(verb.name, verb.summary);
    part->fallthrough();
    part->footer("--gcm, --timeout, --json and others go with every verb: gcm --help");
    part->callback([&run, &chosen, runner = verb.prepare(*part), name = verb.name] {
      run = runner;
      chosen = name;
    });
  }
  if (const std::string unknown = UnknownVerb(words, app); !unknown.empty()) {
    err << "gcm: " << unknown << '\n';
    return program::kUsage;
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success& asked) {
    app.exit(asked, out, err);
    return Finish(program::kOk, out, err);
  } catch (const CLI::ParseError& mistake) {
    err << "gcm: " << program::SentenceOf(mistake, app, HelpCommand(app)) << '\n';
    return program::kUsage;
  }
  settings.gcm = program::GcmAddress(settings.gcm);
  settings.timeout = std::chrono::milliseconds(timeout_ms);
  try {
    Context context(settings, chosen, out, err, columns);
    return Finish(run(context), out, err);
  } catch (const std::exception& failure) {  // no memory, no files left
    err << "gcm: " << Plain(failure.what()) << '\n';
    return program::kRefused;
  }
}

}  // namespace console
