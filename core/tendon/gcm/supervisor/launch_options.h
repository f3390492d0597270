#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// Options for the processes that a GCM starts on its own host.
struct LaunchOptions {
  std::filesystem::path program;  ///< path of `lcm`; empty: the GCM cannot start processes
  /// Returns additional arguments for the command line of `lcm`. `process` comes from the request
  /// and has been checked.
  std::function<std::vector<std::string>(const std::string& process)> options =
      [](const std::string& /*process*/) { return std::vector<std::string>(); };
  /// The size in bytes above which the log of a process is rotated.
  std::uintmax_t longest_log = std::uintmax_t{8} << 20U;
};

}  // namespace tendon
