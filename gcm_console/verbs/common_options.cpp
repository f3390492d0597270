#include <gcm_console/verbs/common_options.h>

#include <program/command_line.h>
#include <tendon/base/clock.h>

#include <CLI/CLI.hpp>
#include <algorithm>

namespace console {

void AddDryRun(CLI::App& app, bool& is_dry) {
  app.add_flag("--dry-run", is_dry, "only print what would be done");
}

void AddCount(CLI::App& app, std::uint64_t& count, const std::string& help) {
  app.add_option("--count", count, help)->transform(CLI::Validator(&program::TransformCount, ""));
}

void AddDuration(CLI::App& app, double& seconds, const std::string& help) {
  app.add_option("--for", seconds, help)
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
}

void AddNoReconnect(CLI::App& app, bool& ends_with_link) {
  app.add_flag("--no-reconnect", ends_with_link,
               "if the GCM or a process is lost, end instead of waiting for it");
}

std::chrono::nanoseconds TimeOf(double seconds) {
  using Seconds = std::chrono::duration<double>;
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::min(Seconds(seconds), Seconds(tendon::kLongestWait)));
}

}  // namespace console
