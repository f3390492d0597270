#pragma once

#include <tendon/base/log.h>
#include <tendon/process/log/log_limiter.h>

#include <mutex>
#include <string>

namespace tendon::ice {

/// Who was not let in under TLS, and why: a line of the audit log each, but for one who tries again
/// and again, whose lines are counted. Thread-safe.
class Refusals {
 public:
  /// `who` is the address, without its port.
  void Add(const std::string& who, const std::string& why);

 private:
  std::mutex mutex_;
  LogLimiter limiter_{{.burst = 10, .interval = std::chrono::seconds(1)}};
};

}  // namespace tendon::ice
