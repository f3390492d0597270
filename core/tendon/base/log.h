#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace tendon {

enum class LogLevel : std::int32_t { kDebug, kInfo, kWarning, kError };

/// One line for people, to stderr and to every sink. `source` is a component's or a part's name.
/// Any thread. In a task's Run() it neither waits, allocates nor calls the operating system: a copy
/// is put aside, and logged by another thread some 20 ms later (DeferLogging). Elsewhere it locks
/// and allocates.
void Log(LogLevel level, std::string_view source, std::string_view message);

/// Records below `level` are dropped; kInfo at the start.
void SetLogLevel(LogLevel level);
/// Whether such a record is not dropped. Any thread; one load.
[[nodiscard]] bool IsLogged(LogLevel level);

using LogSink = std::function<void(LogLevel, std::string_view source, std::string_view message)>;

/// Hears every record that is not dropped, in the logging thread, or in the one that logs what was
/// put aside. Kept for the life of the process.
void AddLogSink(LogSink sink);

using LogTime = std::chrono::system_clock::time_point;

/// Puts records aside for threads that must not wait.
class LogDeferral {
 public:
  /// In the thread that logs; the texts do not outlive the call.
  virtual void PutAside(LogTime time, LogLevel level, std::string_view source,
                        std::string_view message) noexcept = 0;

 protected:
  ~LogDeferral() = default;
};

/// While it lives, what its thread logs goes to a deferral. They may be nested.
class DeferLogging {
 public:
  explicit DeferLogging(LogDeferral& deferral) noexcept;
  DeferLogging(const DeferLogging&) = delete;
  DeferLogging& operator=(const DeferLogging&) = delete;
  ~DeferLogging();

 private:
  LogDeferral* before_;
};

/// Log() with a record that was put aside, or that no level may hide: it is not dropped.
void LogDeferred(LogTime time, LogLevel level, std::string_view source, std::string_view message);

}  // namespace tendon
