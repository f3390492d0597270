#pragma once

#include <sched.h>

namespace tendon::benchmark {

/// The processors of a measurement. The measuring thread runs on the first one.
enum class Processor { kFirst, kSecond };

/// While this object exists, the calling thread stays on one processor. If the kernel allows it,
/// the thread is also a real-time thread, so other programs do not interrupt it. Threads that it
/// starts meanwhile inherit both properties.
class Seat {
 public:
  explicit Seat(Processor processor);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

 private:
  cpu_set_t processors_{};  // this and the following members are the previous values
  int policy_ = SCHED_OTHER;
  sched_param parameters_{};
};

}  // namespace tendon::benchmark
