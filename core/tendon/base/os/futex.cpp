#include <tendon/base/os/futex.h>

#include <linux/futex.h>
#include <linux/membarrier.h>
#include <sys/syscall.h>
#include <tendon/base/log.h>
#include <unistd.h>

#include <climits>
#include <ctime>

namespace tendon::os {
namespace {

timespec ToTimespec(std::chrono::nanoseconds time) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  return {seconds.count(), (time - seconds).count()};
}

const std::uint32_t* Address(const std::atomic<std::uint32_t>& word) {
  static_assert(sizeof(word) == sizeof(std::uint32_t));
  return reinterpret_cast<const std::uint32_t*>(&word);
}

/// Registers for membarrier when the library is loaded. Later, when several threads are running, it
/// would take 10 ms.
const bool kBarrierRegistered =
    syscall(SYS_membarrier, MEMBARRIER_CMD_REGISTER_PRIVATE_EXPEDITED, 0, 0) == 0;

/// Warns once; the program continues without the barrier.
void WarnOfNoBarrier() noexcept {
  static std::atomic<bool> is_said = false;
  if (is_said.exchange(true, std::memory_order_relaxed)) return;
  try {
    Log(LogLevel::kWarning, "tendon",
        "the kernel refuses membarrier, so a disconnect may free memory that a call still uses; "
        "allow this system call, or stop components before you disconnect them");
  } catch (...) {  // NOLINT(bugprone-empty-catch)
  }
}

}  // namespace

void FutexWait(const std::atomic<std::uint32_t>& word, std::uint32_t expected,
               std::chrono::nanoseconds timeout) noexcept {
  const timespec limit = ToTimespec(timeout);
  syscall(SYS_futex, Address(word), FUTEX_WAIT_PRIVATE, expected, &limit, nullptr, 0);
}

void FutexWake(const std::atomic<std::uint32_t>& word) noexcept {
  syscall(SYS_futex, Address(word), FUTEX_WAKE_PRIVATE, INT_MAX, nullptr, nullptr, 0);
}

void ProcessBarrier() noexcept {
  if (kBarrierRegistered && syscall(SYS_membarrier, MEMBARRIER_CMD_PRIVATE_EXPEDITED, 0, 0) == 0) {
    return;
  }
  WarnOfNoBarrier();
  std::atomic_thread_fence(std::memory_order_seq_cst);
}

}  // namespace tendon::os
