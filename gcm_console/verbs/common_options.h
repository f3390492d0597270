#pragma once

#include <cstdint>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

/// Options that several verbs have.
namespace console {

/// --dry-run.
void AddDryRun(CLI::App& app, bool& is_dry);

/// --count NUMBER, above 0.
void AddCount(CLI::App& app, std::uint64_t& count, const std::string& help);

/// --for TIME, in seconds.
void AddDuration(CLI::App& app, double& seconds,
                 const std::string& help = "end after this time: 10s, 500ms, 2min");

/// --no-reconnect.
void AddNoReconnect(CLI::App& app, bool& ends_with_link);

}  // namespace console
