#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>

#include "support/machine/sanitized.h"

namespace faults {

/// The resources that a process uses.
struct Footprint {
  std::size_t descriptors = 0;
  std::size_t threads = 0;
  std::size_t resident = 0;  ///< bytes
};

inline Footprint FootprintOf(int pid) {
  constexpr std::size_t kPage = 4096;
  const std::filesystem::path process("/proc/" + std::to_string(pid));
  const auto entries = [&](const char* folder) {
    std::error_code ignored;
    const std::filesystem::directory_iterator all(process / folder, ignored);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  };
  Footprint footprint{.descriptors = entries("fd"), .threads = entries("task")};
  std::size_t total = 0;
  std::ifstream(process / "statm") >> total >> footprint.resident;
  footprint.resident *= kPage;
  return footprint;
}

/// Returns the bytes of address space, used or not. RLIMIT_AS limits them.
inline std::size_t AddressSpaceOf(int pid) {
  constexpr std::size_t kPage = 4096;
  std::size_t pages = 0;
  std::ifstream("/proc/" + std::to_string(pid) + "/statm") >> pages;
  return pages * kPage;
}

/// The growth of memory that IsFlat() allows. With a sanitizer it is larger, because a sanitizer
/// keeps freed memory.
inline const std::size_t kMemory = std::size_t{tendon::test::IsSanitized() ? 256U : 16U} << 20U;

/// Returns true if the process has no more descriptors than before, no more threads (except those
/// that a pool keeps for a while), and hardly more memory.
inline bool IsFlat(const Footprint& before, const Footprint& now) {
  constexpr std::size_t kPool = 4;
  return now.descriptors <= before.descriptors && now.threads <= before.threads + kPool &&
         now.resident <= before.resident + kMemory;
}

inline std::ostream& operator<<(std::ostream& out, const Footprint& footprint) {
  return out << footprint.descriptors << " descriptors, " << footprint.threads << " threads, "
             << footprint.resident / 1024 << " KiB";
}

}  // namespace faults
