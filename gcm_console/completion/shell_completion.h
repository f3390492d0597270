#pragma once

#include <gcm_console/context.h>

#include <string>
#include <vector>

namespace console {

/// The first word of the command line with which the user's shell requests completions. It is
/// internal, so it is not in the help.
inline constexpr const char* kCompleteVerb = "complete";

/// Called with {"complete", WORDS...}. Prints each completion, followed by a tab and its
/// description; prints ":files" if the word is the name of a file. Takes at most a fraction of a
/// second.
int PrintCompletions(const std::vector<std::string>& words, const Streams& streams);

/// Returns the script that enables completion of `gcm` in the shell "bash", "zsh" or "fish"; empty
/// for other shells.
std::string CompletionFile(const std::string& shell);

}  // namespace console
