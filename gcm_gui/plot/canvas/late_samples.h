#pragma once

#include <gcm_gui/plot/series/sample_ring.h>

#include <cstdint>

namespace tendon::gui {

/// Whether the sample came more than half a period later than those before it let expect. Rows that
/// were lost in between make none late, and it is the same whenever it is asked: what comes behind
/// the sample plays no part. False where too little is known. O(1).
[[nodiscard]] bool IsLate(const SampleRing& samples, std::uint64_t index);

}  // namespace tendon::gui
