#pragma once

#include <gcm_console/help/page.h>
#include <tendon/gcm/catalog.h>

#include <functional>
#include <string>
#include <vector>

namespace console {

/// What can stand at the end of a command line.
struct Completion {
  /// Instead of the last word: "robot/arm/", which goes on, or "robot/arm/Control ", which is
  /// whole.
  struct Candidate {
    std::string text;
    std::string help;

    bool operator==(const Candidate&) const = default;
  };
  std::vector<Candidate> candidates;
  bool is_file = false;  ///< a file is wanted; whoever asks knows those better
};

/// What is asked of a live system, each only where it is wanted.
struct AskSystem {
  std::function<tendon::Catalog()> catalog;
  /// The words of a kind that names no path, behind those arguments of the verb; their paths are
  /// whole.
  std::function<std::vector<std::string>(WordKind kind, const std::vector<std::string>& before)>
      words = nullptr;
};

/// The last of `words` is what is completed, and may be empty. `gcm` is the page of the whole
/// program; paths begin at `at`.
Completion Complete(const Page& gcm, const std::vector<std::string>& words, const AskSystem& system,
                    const std::string& at = "");

/// All paths of that kind, in order; of the ways to them, those that are longer than `prefix` by
/// one name only: "robot/arm/" for "robot/a".
std::vector<std::string> PathsOf(const tendon::Catalog& catalog, WordKind kind,
                                 const std::string& prefix);

}  // namespace console
