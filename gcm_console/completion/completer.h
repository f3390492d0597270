#pragma once

#include <gcm_console/command_line/help_page.h>
#include <tendon/gcm/catalogue.h>

#include <functional>
#include <string>
#include <vector>

namespace console {

/// The possible completions of a command line.
struct WordCompletion {
  /// A replacement for the last word. "robot/arm/" is to be continued, "robot/arm/Control " is
  /// complete.
  struct Suggestion {
    std::string text;
    std::string help;

    bool operator==(const Suggestion&) const = default;
  };
  std::vector<Suggestion> suggestions;
  bool is_file = false;  ///< the word is the name of a file; the caller must complete it
};

/// Functions that return words from the live system. Each function is called only if its words are
/// needed.
struct SystemQueries {
  std::function<tendon::Catalogue()> catalogue;
  /// Returns the words of a kind that is not a path. `before` contains the verb's arguments before
  /// this word; paths in it are absolute.
  std::function<std::vector<std::string>(WordKind kind, const std::vector<std::string>& before)>
      words = nullptr;
};

/// Completes the last of `words`, which may be empty. `gcm` is the page of the whole program.
/// Relative paths are relative to `at`.
WordCompletion Complete(const Page& gcm, const std::vector<std::string>& words,
                        const SystemQueries& system, const std::string& at = "");

/// If the word is the name of a file, adds the files that begin with `word`. Reads the disk.
void AddFiles(WordCompletion& completion, const std::string& word);

/// Returns the common beginning of all suggestions; there must be at least one.
std::string CommonBegin(const std::vector<WordCompletion::Suggestion>& suggestions);

}  // namespace console
