#include "support/real_time_guard.h"

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)

namespace tendon_test {

bool RealTimeGuard::IsAvailable() { return false; }
bool RealTimeGuard::SeesEverySystemCall() { return false; }
void RealTimeGuard::Arm() {}
RealTimeGuard::Counts RealTimeGuard::Disarm() { return {}; }

}  // namespace tendon_test

#else

#include <dlfcn.h>
#include <linux/futex.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <ctime>

namespace tendon_test {
namespace {

using Counts = RealTimeGuard::Counts;

constexpr int kSetSyscallUserDispatch = 59;  // an option of prctl() that older headers lack
constexpr unsigned char kAllow = 0;
constexpr unsigned char kBlock = 1;

constinit thread_local bool is_guarded = false;
constinit thread_local bool is_armed = false;
constinit thread_local bool traps_system_calls = false;
constinit thread_local volatile unsigned char selector = kAllow;  // the kernel reads it
constinit thread_local Counts counts;

void SetArmed(bool armed) {
  if (!is_guarded) return;
  is_armed = armed;
  if (traps_system_calls) selector = armed ? kBlock : kAllow;
}

/// While this object exists, the thread sleeps; sleeping is allowed.
struct Sleep {
  Sleep() { SetArmed(false); }
  ~Sleep() {
    if (is_guarded) ++counts.sleeps;
    SetArmed(true);
  }
};

void CountSystemCall(long number) {
  if (!is_armed || number == SYS_clock_gettime) return;
  ++counts.system_calls;
  counts.last_system_call = number;
}

#if defined(__x86_64__)
/// Counts a trapped call and then allows it: the instruction is repeated. Further calls are not
/// trapped until the thread has slept.
void OnTrap(int /*signal*/, siginfo_t* info, void* context) {
  selector = kAllow;
  CountSystemCall(info->si_syscall);
  constexpr greg_t kSizeOfInstruction = 2;
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP] -= kSizeOfInstruction;
}

bool TrapSystemCalls() {
  struct sigaction action {};
  action.sa_sigaction = OnTrap;
  action.sa_flags = SA_SIGINFO;
  if (sigaction(SIGSYS, &action, nullptr) != 0) return false;
  return prctl(kSetSyscallUserDispatch, 1, 0, 0, &selector) == 0;
}
#else
bool TrapSystemCalls() { return false; }
#endif

template <typename Function>
Function Real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

bool RealTimeGuard::IsAvailable() { return true; }

bool RealTimeGuard::SeesEverySystemCall() {
  if (traps_system_calls) return true;
  const bool can = TrapSystemCalls();
  if (can) prctl(kSetSyscallUserDispatch, 0, 0, 0, 0);
  return can;
}

void RealTimeGuard::Arm() {
  traps_system_calls = TrapSystemCalls();
  counts = {};
  is_guarded = true;
  SetArmed(true);
}

Counts RealTimeGuard::Disarm() {
  SetArmed(false);
  is_guarded = false;
  if (traps_system_calls) prctl(kSetSyscallUserDispatch, 0, 0, 0, 0);
  traps_system_calls = false;
  return counts;
}

}  // namespace tendon_test

// These functions replace functions of the C library.
extern "C" {

using tendon_test::counts;
using tendon_test::is_armed;

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) noexcept {
  if (is_armed) ++counts.allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  if (is_armed) ++counts.allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
  if (is_armed) ++counts.allocations;
  return __libc_realloc(memory, size);
}

void free(void* memory) noexcept {
  if (is_armed && memory != nullptr) ++counts.allocations;
  __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto kReal = tendon_test::Real<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  if (is_armed) ++counts.locks;
  return kReal(mutex);
}

int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  static const auto kReal = tendon_test::Real<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  if (is_armed) ++counts.locks;
  return kReal(lock);
}

int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  static const auto kReal = tendon_test::Real<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  if (is_armed) ++counts.locks;
  return kReal(lock);
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* time, timespec* rest) {
  static const auto kReal =
      tendon_test::Real<int (*)(clockid_t, int, const timespec*, timespec*)>("clock_nanosleep");
  const tendon_test::Sleep sleep;
  return kReal(clock, flags, time, rest);
}

long syscall(long number, ...) noexcept {
  using Function = long (*)(long, long, long, long, long, long, long);
  static const auto kReal = tendon_test::Real<Function>("syscall");
  va_list rest;
  va_start(rest, number);
  long a[6];
  for (long& one : a) one = va_arg(rest, long);
  va_end(rest);
  if (number == SYS_futex && (a[1] & FUTEX_CMD_MASK) == FUTEX_WAIT) {
    const tendon_test::Sleep sleep;
    return kReal(number, a[0], a[1], a[2], a[3], a[4], a[5]);
  }
  if (!tendon_test::traps_system_calls) tendon_test::CountSystemCall(number);
  return kReal(number, a[0], a[1], a[2], a[3], a[4], a[5]);
}

}  // extern "C"

#endif
