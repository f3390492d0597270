#include <tendon/base/os/thread.h>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <ctime>
#include <system_error>

namespace tendon::os {
namespace {

Permission Outcome(int error) {
  if (error == 0) return {};
  return {.granted = false, .reason = std::generic_category().message(error)};
}

}  // namespace

void NameThisThread(const std::string& name) noexcept {
  constexpr std::size_t kLongest = 15;
  pthread_setname_np(pthread_self(), name.substr(0, kLongest).c_str());
}

void SleepUntil(SteadyTime time) noexcept {
  const auto since = time.time_since_epoch();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(since);
  const timespec until{seconds.count(), (since - seconds).count()};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

void SetTimerSlack(std::uint64_t nanoseconds) noexcept { prctl(PR_SET_TIMERSLACK, nanoseconds); }

Permission SetRealTimePriority(int priority, bool is_fifo) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return Outcome(
      pthread_setschedparam(pthread_self(), is_fifo ? SCHED_FIFO : SCHED_RR, &parameters));
}

void LowerPriority() noexcept {
  const sched_param none{};
  (void)pthread_setschedparam(pthread_self(), SCHED_OTHER, &none);  // the creator may be real-time
  constexpr int kNice = 10;
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

Permission RunOnProcessors(std::span<const std::int32_t> processors) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const std::int32_t processor : processors) {
    if (processor < 0 || processor >= CPU_SETSIZE) return Outcome(EINVAL);
    CPU_SET(static_cast<std::size_t>(processor), &set);
  }
  return Outcome(pthread_setaffinity_np(pthread_self(), sizeof(set), &set));
}

int ProcessorCount() noexcept { return static_cast<int>(sysconf(_SC_NPROCESSORS_CONF)); }

Permission LockMemory() { return Outcome(mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? 0 : errno); }

void TouchStack(std::size_t bytes) noexcept {
  constexpr std::size_t kPage = 4096;
  std::array<volatile char, kPage> page;
  page[0] = 0;
  if (bytes > kPage) TouchStack(bytes - kPage);
  page[kPage - 1] = 0;  // written after the call, so that the compiler keeps this frame
                        // before the call
}

std::chrono::nanoseconds ThreadCpuTime() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace tendon::os
