#pragma once

#include <sched.h>

namespace tendon::benchmark {

/// The processors of a measurement: the thread that measures has the first.
enum class Processor { kFirst, kSecond };

/// While it lives, the calling thread stays on a processor, and is not interrupted there by other
/// programs where the kernel lets it be a real-time thread. Threads that it starts meanwhile
/// inherit both.
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
