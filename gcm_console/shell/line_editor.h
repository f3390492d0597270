#pragma once

#include <gcm_console/shell/line_reader.h>

#include <filesystem>
#include <memory>

namespace console {

/// Reads lines from the terminal with libedit: editing, Tab completion, history, and the user's
/// ~/.editrc. Ctrl-D ends the input, Ctrl-C empties the line. Output of background jobs appears
/// above the line, which is then redrawn. The history is read from a file and saved after each
/// line; without a usable file there is none. At most one at a time in a program.
std::unique_ptr<LineReader> MakeLineEditor(const std::filesystem::path& history,
                                           AskCompletion completion, AskLines lines);

}  // namespace console
