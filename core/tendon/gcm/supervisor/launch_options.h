#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// How a GCM starts processes on its own host.
struct LaunchOptions {
  std::filesystem::path program;  ///< path of `lcm`; empty: the GCM cannot start processes
  /// Returns further arguments for the command line of `lcm`. The process name comes from the
  /// request and was checked before.
  std::function<std::vector<std::string>(const std::string& process)> options =
      [](const std::string& /*process*/) { return std::vector<std::string>(); };
  /// The log of a process is rotated when it is larger than this; bytes.
  std::uintmax_t longest_log = std::uintmax_t{8} << 20U;
};

}  // namespace tendon
