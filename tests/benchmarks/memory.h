#pragma once

#include <malloc.h>

namespace tendon::benchmark {

/// What this program frees it keeps for itself. Else the allocator gives the top of a heap back to
/// the kernel, which clears it anew page by page, or not, as what was measured before has left it:
/// a large answer takes half as long or twice as long for that alone, ours and the floor's.
inline void KeepMemory() {
  constexpr int kForLargeAnswers = 64 << 20;
  constexpr int kMost = 512 << 20;
  mallopt(M_MMAP_THRESHOLD, kForLargeAnswers);
  mallopt(M_TRIM_THRESHOLD, kMost);
}

}  // namespace tendon::benchmark
