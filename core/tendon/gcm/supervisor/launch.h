#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// How a GCM starts processes on its own host.
struct Launch {
  std::filesystem::path program;  ///< an `lcm`; empty: it starts none
  /// More arguments of its command line. The request contributes only the process name, which is
  /// valid.
  std::function<std::vector<std::string>(const std::string& process)> options =
      [](const std::string& /*process*/) { return std::vector<std::string>(); };
  /// The size in bytes at which the log of a process is rotated.
  std::uintmax_t longest_log = std::uintmax_t{8} << 20U;
};

}  // namespace tendon
