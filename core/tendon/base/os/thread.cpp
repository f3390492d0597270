#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <tendon/base/os/thread.h>

#include <cerrno>
#include <ctime>

namespace tendon::os {

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

bool SetRealTimePriority(int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

std::chrono::nanoseconds ThreadCpuTime() noexcept {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace tendon::os
