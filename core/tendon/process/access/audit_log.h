#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/log/log_limiter.h>
#include <tendon/security/role.h>

#include <mutex>
#include <string>

namespace tendon {

/// Who did what, and who was refused: the source "audit" of this process' log. No log level hides
/// its lines, for who sets one must not cover what is done next. Beyond ten a second of one program
/// they are counted, and the count is written. Thread-safe.
class AuditLog {
 public:
  AuditLog();
  AuditLog(const AuditLog&) = delete;
  AuditLog& operator=(const AuditLog&) = delete;
  ~AuditLog();

  /// `who` tells one program from another, where this log is of several.
  void Write(const std::string& who, LogLevel level, const std::string& line);

 private:
  void WriteSuppressed(SteadyTime now);

  std::mutex mutex_;
  LogLimiter limiter_;
};

/// "desk (operator, 127.0.0.1:41234)", of one line whatever the peer calls itself.
[[nodiscard]] std::string NameAndRole(const Channel& channel, Role role);

}  // namespace tendon
