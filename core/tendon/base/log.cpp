#include <tendon/base/log.h>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon {
namespace {

spdlog::level::level_enum ToSpdlog(LogLevel level) {
  switch (level) {
    case LogLevel::kDebug:
      return spdlog::level::debug;
    case LogLevel::kInfo:
      return spdlog::level::info;
    case LogLevel::kWarning:
      return spdlog::level::warn;
    case LogLevel::kError:
      return spdlog::level::err;
  }
  return spdlog::level::info;
}

/// The log of the process. It goes to stderr, because stdout is for data only.
struct Sinks {
  std::shared_ptr<spdlog::logger> console = [] {
    auto logger = std::make_shared<spdlog::logger>(
        "tendon", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    logger->set_pattern("%H:%M:%S.%e %^%-7l%$ %v");
    return logger;
  }();
  std::mutex mutex;
  std::vector<LogSink> others;
};

Sinks& TheSinks() {
  // Never freed, because code that runs at the end of the process may log.
  static Sinks& sinks = *new Sinks;
  return sinks;
}

thread_local LogDeferral* the_deferral = nullptr;

}  // namespace

void Log(LogLevel level, std::string_view source, std::string_view message) {
  if (!IsLogged(level)) return;
  const LogTime now = std::chrono::system_clock::now();
  if (the_deferral != nullptr) return the_deferral->Defer(now, level, source, message);
  LogDeferred(now, level, source, message);
}

void LogDeferred(LogTime time, LogLevel level, std::string_view source, std::string_view message) {
  Sinks& sinks = TheSinks();
  std::string line(source);
  line.append(": ").append(message);
  // Writes directly to the sinks, without a check of the level: the caller has checked it, or the
  // record must appear at every level.
  const spdlog::details::log_msg record(time, {}, sinks.console->name(), ToSpdlog(level), line);
  for (const auto& sink : sinks.console->sinks()) {
    try {
      sink->log(record);
    } catch (const std::exception&) {
      // A failure to write the log is not reported to the caller.
    }
  }
  const std::scoped_lock lock(sinks.mutex);
  for (const LogSink& sink : sinks.others) sink(level, source, message);
}

LogDeferralScope::LogDeferralScope(LogDeferral& deferral) noexcept
    : before_(std::exchange(the_deferral, &deferral)) {}

LogDeferralScope::~LogDeferralScope() { the_deferral = before_; }

void SetLogLevel(LogLevel level) { TheSinks().console->set_level(ToSpdlog(level)); }

bool IsLogged(LogLevel level) { return TheSinks().console->should_log(ToSpdlog(level)); }

void AddLogSink(LogSink sink) {
  Sinks& sinks = TheSinks();
  const std::scoped_lock lock(sinks.mutex);
  sinks.others.push_back(std::move(sink));
}

}  // namespace tendon
