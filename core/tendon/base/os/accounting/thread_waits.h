#pragma once

#include <cstdint>

namespace tendon::os {

/// How often the calling thread has given up its processor in order to wait: for a lock, a file,
/// somebody's answer. That it was put aside for another thread does not count, nor that a page of
/// memory came from the disk. Two calls tell how often in between.
[[nodiscard]] std::int64_t ThreadWaits() noexcept;

}  // namespace tendon::os
