#pragma once

#include <gcm_console/help/page.h>
#include <gcm_console/line/settings.h>
#include <gcm_console/line/word_kind.h>
#include <gcm_console/verb.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace console {

/// The command line of `gcm`, made from the table of verbs: what a line means is here after
/// Parse().
class CommandLine {
 public:
  /// The path that a person means who stands somewhere and types the beginnings of names, or a path
  /// from the top, see PathFrom() and WholePath().
  using Complement = std::function<std::string(WordKind kind, const std::string& typed)>;

  /// `usual` is what holds where a line says nothing else. In a session, `complement` may be given
  /// for lines that a person types.
  explicit CommandLine(Settings usual, Complement complement = nullptr);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The error, kInvalid, is one sentence. Throws CLI::Success where help is wanted, or the
  /// version.
  tendon::Result<void> Parse(const std::vector<std::string>& words);

  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] const Verb::Run& run() const { return run_; }

  /// Of `gcm`, with a part for each verb.
  [[nodiscard]] Page page() const { return PageOf(app_); }
  /// Of the verb that was given, or of the act of it; else of `gcm`.
  [[nodiscard]] Page chosen_page() const;

 private:
  void AddSettings();
  void AddVerb(const Verb& verb);
  void Resolve(CLI::App& part) const;

  CLI::App app_{"see and steer a system of components through its GCM", "gcm"};
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

/// A path as it is typed where paths begin at `at`: "/robot" begins at the top, ".." goes up.
std::string ResolvedPath(const std::string& at, const std::string& typed);

/// "gcm 0.1.0".
std::string VersionLine();

}  // namespace console
