#pragma once

#include <gcm_gui/plot/series/sample_ring.h>

#include <cstdint>

namespace tendon::gui {

/// Returns true if the sample came more than half a period later than expected from the previous
/// samples. Lost rows in between do not count as lateness. Returns false if there are too few
/// previous samples. The result does not depend on later samples, so it never changes. O(1).
[[nodiscard]] bool IsLate(const SampleRing& samples, std::uint64_t index);

}  // namespace tendon::gui
