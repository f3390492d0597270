#pragma once

#include <gcm_gui/plot/series/sample_ring.h>

#include <cstdint>

namespace tendon::gui {

/// True if the sample came more than half a period later than expected from the previous samples.
/// Lost rows in between do not count as lateness. The result never changes, because it does not
/// depend on later samples. False if there are too few samples. O(1).
[[nodiscard]] bool IsLate(const SampleRing& samples, std::uint64_t index);

}  // namespace tendon::gui
