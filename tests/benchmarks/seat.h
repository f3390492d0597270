#pragma once

#include <sched.h>

namespace tendon::benchmark {

/// The processors of a measurement: the thread that measures has the first.
enum class Processor { kFirst, kSecond };

/// While this object exists, the calling thread stays on one processor. If the kernel allows it to
/// be a real-time thread, other programs do not interrupt it there. Threads that it starts
/// meanwhile inherit both.
class Seat {
 public:
  explicit Seat(Processor processor);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

 private:
  cpu_set_t processors_{};  // as they were before, like the rest
  int policy_ = SCHED_OTHER;
  sched_param parameters_{};
};

}  // namespace tendon::benchmark
