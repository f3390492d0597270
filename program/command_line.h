#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace program {

/// The mistake in a command line and the remedy, in one sentence: "no option '--jsn'; did you mean
/// '--json'? gcm --help tells more". `command` is the command whose --help is suggested.
std::string SentenceOf(const CLI::ParseError& mistake, const CLI::App& app,
                       const std::string& command);

/// For CLI::Option::transform(). They read numbers like tendon::ReadNumberLiteral(), the same in
/// every locale, and say what to write instead of an invalid number.
///
/// A number above zero.
std::string TransformPositive(std::string& text);

/// A whole number, at least 1.
std::string TransformCount(std::string& text);

/// Converts "500ms", "10s", "2min" or a plain number to seconds.
std::string TransformDuration(std::string& text);

/// The same to whole milliseconds, from 1 to an hour; a plain number is in milliseconds.
std::string TransformMilliseconds(std::string& text);

}  // namespace program
