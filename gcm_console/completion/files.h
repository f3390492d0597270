#pragma once

#include <gcm_console/completion/completer.h>

#include <string>
#include <vector>

namespace console {

/// If the completion needs a file, adds the files that begin with `word`. Reads the disk.
void AddFiles(Completion& completion, const std::string& word);

/// The common prefix of all candidates; there must be at least one.
std::string CommonBegin(const std::vector<Completion::Candidate>& candidates);

}  // namespace console
