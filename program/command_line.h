#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace program {

/// What is wrong with a command line, in one sentence with what to do next: "no option '--jsn'; did
/// you mean '--json'? gcm --help tells more". `command` is what --help is asked of.
std::string SentenceOf(const CLI::ParseError& mistake, const CLI::App& app,
                       const std::string& command);

/// For CLI::Option::transform(), which take numbers as tendon::ReadNumberWord() does, in every
/// locale alike, and say what to write instead of what is none.
///
/// A number above zero.
std::string TransformPositive(std::string& text);

/// A whole number from 1 on.
std::string TransformCount(std::string& text);

/// "500ms", "10s", "2min" or a plain number becomes that many seconds.
std::string TransformDuration(std::string& text);

/// The same in whole milliseconds, 1 to an hour, which a plain number is too.
std::string TransformMilliseconds(std::string& text);

}  // namespace program
