#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/process/log/log_limiter.h>

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

}  // namespace tendon
