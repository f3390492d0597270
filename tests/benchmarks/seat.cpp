#include <benchmarks/seat.h>
#include <pthread.h>
#include <tendon/base/os/thread.h>

namespace tendon::benchmark {

Seat::Seat(Processor processor) {
  constexpr int kSeatPriority = 10;
  const pthread_t self = pthread_self();
  pthread_getaffinity_np(self, sizeof(processors_), &processors_);
  pthread_getschedparam(self, &policy_, &parameters_);
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<unsigned>(static_cast<int>(processor) % os::ProcessorCount()), &one);
  // If the kernel refuses this, the measurement continues without it.
  pthread_setaffinity_np(self, sizeof(one), &one);
  sched_param real_time{};
  real_time.sched_priority = kSeatPriority;
  pthread_setschedparam(self, SCHED_FIFO, &real_time);
}

Seat::~Seat() {
  const pthread_t self = pthread_self();
  pthread_setschedparam(self, policy_, &parameters_);
  pthread_setaffinity_np(self, sizeof(processors_), &processors_);
}

}  // namespace tendon::benchmark
