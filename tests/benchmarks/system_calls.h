#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace tendon::benchmark {

/// Runs `work(from_now_on)` in its own thread. Counts the system calls that this thread makes after
/// it has called `from_now_on()`. The calls are executed, but slowly, because the kernel reports
/// each call to this program. Empty if the kernel does not allow this.
std::optional<std::uint64_t> CountSystemCalls(
    const std::function<void(const std::function<void()>& from_now_on)>& work);

}  // namespace tendon::benchmark
