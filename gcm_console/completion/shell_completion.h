#pragma once

#include <gcm_console/context.h>

#include <string>
#include <vector>

namespace console {

/// The first word of the command line with which a user's shell asks for completions. Internal, so
/// it is not in the help.
inline constexpr const char* kCompleteVerb = "complete";

/// {"complete", WORDS...}: prints each candidate, a tab and its description; prints ":files" if the
/// word is a file name. Takes a fraction of a second at most.
int PrintCompletions(const std::vector<std::string>& words, const Streams& streams);

/// The script that enables completion for `gcm` in "bash", "zsh" or "fish"; empty for other shells.
std::string CompletionFile(const std::string& shell);

}  // namespace console
