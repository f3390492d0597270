#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/log/log_limiter.h>
#include <tendon/security/role.h>

#include <mutex>
#include <string>

namespace tendon {

/// Records changes and refusals, with the program that asked, as the source "audit" in this
/// process's log. These lines are written at every log level, so that nobody can hide an action by
/// changing the level. For more than ten lines a second from one program, writes only their count.
/// Thread-safe.
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

/// "desk (operator, 127.0.0.1:41234)"; always one line, whatever name the peer gives.
[[nodiscard]] std::string NameAndRole(const Channel& channel, Role role);

}  // namespace tendon
