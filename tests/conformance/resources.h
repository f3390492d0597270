#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace tendon::conformance {

inline std::size_t EntriesIn(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator entries(folder);
  return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
}

inline std::size_t OpenDescriptors() { return EntriesIn("/proc/self/fd"); }
inline std::size_t Threads() { return EntriesIn("/proc/self/task"); }

/// Resident bytes of this process.
inline std::size_t MemoryInUse() {
  constexpr std::size_t kPage = 4096;
  std::size_t total = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * kPage;
}

}  // namespace tendon::conformance
