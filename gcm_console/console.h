#pragma once

#include <gcm_console/context.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace console {

/// Runs one command line, given without the name of the program: {"connect", "a/b/C", "d/e/F",
/// "--json"}. Writes data to `out` and messages to `err`. `columns` is the width of the terminal
/// behind `out`; 0 if there is no terminal. Returns the exit code.
int RunCommandLine(const std::vector<std::string>& words, std::ostream& out, std::ostream& err,
                   int columns);

int RunCommandLine(const std::vector<std::string>& words, const Streams& streams);

/// Runs one of several command lines of a session.
int RunCommandLine(const std::vector<std::string>& words, const Streams& streams,
                   ShellSession& session);

}  // namespace console
