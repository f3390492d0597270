#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

/// Options that several verbs have.
namespace console {

/// Adds --dry-run.
void AddDryRun(CLI::App& app, bool& is_dry);

/// Adds --count NUMBER, which must be above 0.
void AddCount(CLI::App& app, std::uint64_t& count, const std::string& help);

/// Adds --for TIME; `seconds` receives the time in s.
void AddDuration(CLI::App& app, double& seconds,
                 const std::string& help = "end after this time: 10s, 500ms, 2min");

/// Adds --no-reconnect.
void AddNoReconnect(CLI::App& app, bool& ends_with_link);

/// Returns a time that was given in s, limited to kLongestWait.
std::chrono::nanoseconds TimeOf(double seconds);

}  // namespace console
