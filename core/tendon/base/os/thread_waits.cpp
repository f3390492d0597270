#include <sys/resource.h>
#include <tendon/base/os/thread_waits.h>

namespace tendon::os {

std::int64_t ThreadWaits() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nvcsw - usage.ru_majflt;
}

}  // namespace tendon::os
