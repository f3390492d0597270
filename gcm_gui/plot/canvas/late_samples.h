#pragma once

#include <gcm_gui/plot/series/sample_ring.h>

#include <cstdint>

namespace tendon::gui {

/// True if the sample came more than half a period later than the previous ones suggest. Lost rows
/// in between do not count as lateness. The result never changes, because later samples play no
/// part. False if too little is known. O(1).
[[nodiscard]] bool IsLate(const SampleRing& samples, std::uint64_t index);

}  // namespace tendon::gui
