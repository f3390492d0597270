#pragma once

#include <gcm_console/shell/line_reader.h>

#include <filesystem>
#include <memory>

namespace console {

/// Reads lines from the terminal with libedit: with editing, completion by Tab, history, and the
/// settings of the user's ~/.editrc. Ctrl-D ends the input, Ctrl-C empties the line. Output of
/// background jobs is printed above the line, and the line is drawn again. The history is read from
/// a file; each line is appended to the file. If the file cannot be used, there is no history. A
/// program can have only one reader at a time.
std::unique_ptr<LineReader> MakeLineEditor(const std::filesystem::path& history,
                                           AskCompletion completion, AskLines lines);

}  // namespace console
