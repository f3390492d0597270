#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/log/log_limiter.h>
#include <tendon/security/role.h>

#include <mutex>
#include <string>

namespace tendon {

/// Records changes and refusals in the log of this process, with the name of the program that sent
/// the request. The source of these lines is "audit". They are written at every log level, so that
/// nobody can hide an action by changing the level. If one program causes more than ten lines a
/// second, the log gets only their number. Thread-safe.
class AuditLog {
 public:
  AuditLog();
  AuditLog(const AuditLog&) = delete;
  AuditLog& operator=(const AuditLog&) = delete;
  ~AuditLog();

  /// `who` identifies the program whose lines are counted.
  void Write(const std::string& who, LogLevel level, const std::string& line);

 private:
  void WriteSuppressed(SteadyTime now);

  std::mutex mutex_;
  LogLimiter limiter_;
};

/// Returns "desk (operator, 127.0.0.1:41234)". The text is always one line, even if the peer's name
/// is not.
[[nodiscard]] std::string NameAndRole(const Channel& channel, Role role);

}  // namespace tendon
