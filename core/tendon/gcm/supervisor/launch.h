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
  /// Further words of its command line; nothing of them comes from who asks for the process, whose
  /// name is valid.
  std::function<std::vector<std::string>(const std::string& process)> options =
      [](const std::string& /*process*/) { return std::vector<std::string>(); };
  /// What a process writes is put aside when it is longer, in bytes.
  std::uintmax_t longest_log = std::uintmax_t{8} << 20U;
};

}  // namespace tendon
