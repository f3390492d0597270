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

/// The command line of `gcm`, built from the table of verbs. After Parse(), it holds the parsed
/// line.
class CommandLine {
 public:
  /// Turns a typed path into an absolute one. The user may abbreviate names and give a relative
  /// path; see PathFrom() and WholePath().
  using Complement = std::function<std::string(WordKind kind, const std::string& typed)>;

  /// `usual` holds the default settings of a line. `complement` completes paths on lines that a
  /// person types in a session.
  explicit CommandLine(Settings usual, Complement complement = nullptr);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The error, kInvalid, is one sentence. Throws CLI::Success if the line asks for help or the
  /// version.
  tendon::Result<void> Parse(const std::vector<std::string>& words);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] const Verb::Run& run() const { return run_; }

  /// The page of `gcm`, with a part for each verb.
  [[nodiscard]] Page page() const { return PageOf(app_); }
  /// The page of the chosen verb or subcommand; else the page of `gcm`.
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

/// The absolute path of `typed` relative to `at`: "/robot" begins at the top, ".." goes up.
std::string ResolvedPath(const std::string& at, const std::string& typed);

/// "gcm 0.1.0".
std::string VersionLine();

}  // namespace console
