#pragma once

#include <gcm_console/command_line/help_page.h>
#include <gcm_console/command_line/settings.h>
#include <gcm_console/command_line/word_kind.h>
#include <gcm_console/verbs/verb.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace console {

/// The command line of `gcm`, built from the table of verbs. After Parse(), it contains the
/// settings, the verb and its arguments.
class CommandLine {
 public:
  /// Converts a path as typed to an absolute path. The user may abbreviate names and may type a
  /// relative path; see PathFrom() and WholePath().
  using Complement = std::function<std::string(WordKind kind, const std::string& typed)>;

  /// `usual` contains the default settings. `complement` completes the paths of lines that a person
  /// types in a session.
  explicit CommandLine(Settings usual, Complement complement = nullptr);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Parses the words of a line. The error kInvalid is one sentence. Throws CLI::Success if the
  /// line asks for help or for the version.
  tendon::Result<void> Parse(const std::vector<std::string>& words);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] const Verb::Run& run() const { return run_; }

  /// Returns the help page of `gcm`, with a part for each verb.
  [[nodiscard]] Page page() const { return PageOf(app_); }
  /// Returns the help page of the chosen verb or subcommand; without a verb, the page of `gcm`.
  [[nodiscard]] Page chosen_page() const;

 private:
  void AddSettings();
  void AddVerb(const Verb& verb);
  void Resolve(CLI::App& part) const;

  CLI::App app_{"show and control a system of components through its GCM", "gcm"};
  Settings settings_;
  const Complement complement_;
  int timeout_ms_ = 0;
  bool is_quiet_ = false;
  bool is_verbose_ = false;
  bool has_no_titles_ = false;
  std::string color_;
  std::string verb_;
  Verb::Run run_;
};

/// Returns the absolute path of `typed` relative to `at`. "/robot" begins at the top, ".." goes one
/// level up.
std::string ResolvedPath(const std::string& at, const std::string& typed);

/// Returns "gcm 0.1.0".
std::string VersionLine();

}  // namespace console
