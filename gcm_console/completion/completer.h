#pragma once

#include <gcm_console/command_line/help_page.h>
#include <tendon/gcm/catalogue.h>

#include <functional>
#include <string>
#include <vector>

namespace console {

/// The possible endings of a command line.
struct WordCompletion {
  /// Replaces the last word: "robot/arm/" is incomplete, "robot/arm/Control " is complete.
  struct Suggestion {
    std::string text;
    std::string help;

    bool operator==(const Suggestion&) const = default;
  };
  std::vector<Suggestion> suggestions;
  bool is_file = false;  ///< the word is a file name, which the caller completes
};

/// The sources of words from the live system. Each function is called only if needed.
struct SystemQueries {
  std::function<tendon::Catalogue()> catalogue;
  /// The words of a kind that is not a path. `before` holds the verb's earlier arguments, with
  /// complete paths.
  std::function<std::vector<std::string>(WordKind kind, const std::vector<std::string>& before)>
      words = nullptr;
};

/// Completes the last of `words`, which may be empty. `gcm` is the page of the whole program;
/// relative paths begin at `at`.
WordCompletion Complete(const Page& gcm, const std::vector<std::string>& words,
                        const SystemQueries& system, const std::string& at = "");

/// If the completion needs a file, adds the files that begin with `word`. Reads the disk.
void AddFiles(WordCompletion& completion, const std::string& word);

/// The common prefix of all suggestions; there must be at least one.
std::string CommonBegin(const std::vector<WordCompletion::Suggestion>& suggestions);

}  // namespace console
