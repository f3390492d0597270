#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tendon {

/// How a GCM starts processes on its own host.
struct Launch {
  std::filesystem::path program;  ///< an `lcm`; empty: it starts none
  /// Further words of its command line; nothing of them comes from who asks for the process, whose
  /// name is valid.
  std::function<std::vector<std::string>(const std::string& process)> options =
      [](const std::string& /*process*/) { return std::vector<std::string>(); };
};

}  // namespace tendon
