#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace tendon {

enum class LogLevel : std::int32_t { kDebug, kInfo, kWarning, kError };

/// Logs one line for people, to stderr and to every sink. `source` is the name of a component, or
/// of the part of the program that logs. Any thread.
///
/// In a task's Run(), this function stores a copy of the line and never waits, allocates or calls
/// the operating system; another thread logs the copy about 20 ms later (LogDeferralScope).
/// Elsewhere, this function locks and allocates.
void Log(LogLevel level, std::string_view source, std::string_view message);

/// Drops records below `level`; kInfo by default.
void SetLogLevel(LogLevel level);
/// True if records of `level` are not dropped. Any thread; costs one load.
[[nodiscard]] bool IsLogged(LogLevel level);

using LogSink = std::function<void(LogLevel, std::string_view source, std::string_view message)>;

/// Adds a sink, which gets every record that is not dropped. The sink is called in the thread that
/// logs, or in the thread that logs deferred records. It is kept until the process ends.
void AddLogSink(LogSink sink);

using LogTime = std::chrono::system_clock::time_point;

/// Stores log records for threads that must not wait.
class LogDeferral {
 public:
  /// Stores one record. Called in the thread that logs; the texts are valid only during the call.
  virtual void Defer(LogTime time, LogLevel level, std::string_view source,
                     std::string_view message) noexcept = 0;

 protected:
  ~LogDeferral() = default;
};

/// While this object exists, the log records of the thread that made it are not logged, but stored
/// in `deferral`. If scopes are nested, the deferral of the innermost scope gets the records.
class LogDeferralScope {
 public:
  explicit LogDeferralScope(LogDeferral& deferral) noexcept;
  LogDeferralScope(const LogDeferralScope&) = delete;
  LogDeferralScope& operator=(const LogDeferralScope&) = delete;
  ~LogDeferralScope();

 private:
  LogDeferral* before_;
};

/// Logs a record without checking its level. For deferred records, whose level was checked before,
/// and for records that must appear at every log level.
void LogDeferred(LogTime time, LogLevel level, std::string_view source, std::string_view message);

}  // namespace tendon
