#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// How a GCM starts processes on its own host.
struct LaunchOptions {
  std::filesystem::path program;  ///< path of `lcm`; empty: no processes can be started
  /// Further arguments of its command line. Only the process name comes from the request, and was
  /// checked.
  std::function<std::vector<std::string>(const std::string& process)> options =
      [](const std::string& /*process*/) { return std::vector<std::string>(); };
  /// The size in bytes at which the log of a process is rotated.
  std::uintmax_t longest_log = std::uintmax_t{8} << 20U;
};

}  // namespace tendon
