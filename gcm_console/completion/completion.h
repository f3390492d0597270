#pragma once

#include <gcm_console/context.h>

#include <string>
#include <vector>

namespace console {

/// The first word of a command line by which a user's shell asks what its last word may become. Not
/// for people, and in no help.
inline constexpr const char* kCompleteVerb = "complete";

/// {"complete", WORDS...}: prints each candidate, a tab, and what it is; or ":files" where a file
/// is wanted. Takes a fraction of a second at most.
int PrintCompletions(const std::vector<std::string>& words, const Streams& streams);

/// The file that makes "bash", "zsh" or "fish" complete the words behind `gcm`; empty for others.
std::string CompletionFile(const std::string& shell);

}  // namespace console
