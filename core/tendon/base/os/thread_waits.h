#pragma once

#include <cstdint>

namespace tendon::os {

/// How often the calling thread has given up its processor to wait: for a lock, a file or a reply.
/// Preemption by another thread and page faults from the disk do not count. The difference of two
/// calls is the number of waits in between.
[[nodiscard]] std::int64_t ThreadWaits() noexcept;

}  // namespace tendon::os
