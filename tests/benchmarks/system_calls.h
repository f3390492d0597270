#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace tendon::benchmark {

/// Runs `work(from_now_on)` in a thread of its own and counts the system calls which that thread
/// makes after it has called `from_now_on()`. The calls are executed, but slowly, because the
/// kernel notifies this program of each one. Empty if the kernel does not allow it.
std::optional<std::uint64_t> CountSystemCalls(
    const std::function<void(const std::function<void()>& from_now_on)>& work);

}  // namespace tendon::benchmark
