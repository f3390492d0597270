#pragma once

#include <gcm_console/shell/line_reader.h>

#include <filesystem>
#include <memory>

namespace console {

/// Lines from the terminal, which can be edited, completed with Tab and taken from the history:
/// with libedit, the user's ~/.editrc and all. Ctrl-D ends them, Ctrl-C makes one empty. What
/// else is to be printed meanwhile stands above the line, which is drawn anew. The history is read
/// from a file and written to it after each line; without one if it cannot be. One at a time in a
/// program.
std::unique_ptr<LineReader> MakeLineEditor(const std::filesystem::path& history,
                                           AskCompletion completion, AskLines lines);

}  // namespace console
