#pragma once

#include <malloc.h>

#include <fstream>
#include <string>

namespace tendon::benchmark {

/// Keeps freed memory in this program. Otherwise the allocator may return the top of a heap to the
/// kernel, which later clears it page by page. Whether this happens depends on the earlier
/// measurements. It would halve or double the time of a large reply, for Tendon and for the
/// code that it is compared with.
inline void KeepMemory() {
  constexpr int kForLargeAnswers = 64 << 20;
  constexpr int kMax = 512 << 20;
  mallopt(M_MMAP_THRESHOLD, kForLargeAnswers);
  mallopt(M_TRIM_THRESHOLD, kMax);
}

/// Returns a figure of a process (a pid or "self") from the file `status` in /proc, in bytes:
/// VmRSS, the memory now, or VmHWM, its peak. Returns 0 if the process has ended.
inline double MemoryFigure(const std::string& process, const std::string& name) {
  constexpr double kKibibyte = 1024;
  std::ifstream status("/proc/" + process + "/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == name + ":" && status >> kibibytes) return kKibibyte * kibibytes;
  }
  return 0;
}

}  // namespace tendon::benchmark
