#pragma once

#include <gcm_console/completion/completer.h>

#include <string>
#include <vector>

namespace console {

/// Where a file is wanted: the names in its folder that begin as `word` does. Reads the disk.
void AddFiles(Completion& completion, const std::string& word);

/// What all candidates begin with; there is at least one.
std::string CommonBegin(const std::vector<Completion::Candidate>& candidates);

}  // namespace console
