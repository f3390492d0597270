#pragma once

#include <gcm_console/context.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace console {

/// Runs one command line without the program's name: {"connect", "a/b/C", "d/e/F", "--json"}.
/// Writes data to `out` and messages to `err`. `columns` is the width of the terminal behind `out`,
/// 0 if it is not a terminal. Returns the exit code.
int RunCommandLine(const std::vector<std::string>& words, std::ostream& out, std::ostream& err,
                   int columns);

int RunCommandLine(const std::vector<std::string>& words, const Streams& streams);

/// The same for one of several lines of a session.
int RunCommandLine(const std::vector<std::string>& words, const Streams& streams,
                   ShellSession& session);

}  // namespace console
