#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace program {

/// Returns one sentence with the mistake in a command line and the remedy: "no option '--jsn'; did
/// you mean '--json'? gcm --help tells more". `command` is the command whose --help is suggested.
std::string SentenceOf(const CLI::ParseError& mistake, const CLI::App& app,
                       const std::string& command);

/// The following functions are for CLI::Option::transform(). They read numbers with
/// tendon::ReadNumberLiteral(), in the same way in every locale. If a number is invalid, the
/// returned text says what to write instead.
///
/// Accepts a number above zero.
std::string TransformPositive(std::string& text);

/// Accepts a whole number that is at least 1.
std::string TransformCount(std::string& text);

/// Converts "500ms", "10s", "2min" or a plain number to seconds.
std::string TransformDuration(std::string& text);

/// Like TransformDuration(), but converts to whole milliseconds, from 1 ms to an hour. A plain
/// number is in milliseconds.
std::string TransformMilliseconds(std::string& text);

}  // namespace program
