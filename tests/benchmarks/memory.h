#pragma once

#include <malloc.h>

namespace tendon::benchmark {

/// Keeps freed memory in this program. Otherwise the allocator may return the top of a heap to the
/// kernel, which later clears it page by page. Whether this happens depends on the earlier
/// measurements. It would halve or double the time of a large answer, for Tendon and for the
/// code that it is compared with.
inline void KeepMemory() {
  constexpr int kForLargeAnswers = 64 << 20;
  constexpr int kMost = 512 << 20;
  mallopt(M_MMAP_THRESHOLD, kForLargeAnswers);
  mallopt(M_TRIM_THRESHOLD, kMost);
}

}  // namespace tendon::benchmark
