#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <tendon/base/log.h>

#include <memory>
#include <mutex>
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

/// The process' log: stderr, so that a program's standard output stays data.
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
  static Sinks sinks;
  return sinks;
}

}  // namespace

void Log(LogLevel level, std::string_view source, std::string_view message) {
  Sinks& sinks = TheSinks();
  if (!sinks.console->should_log(ToSpdlog(level))) return;
  sinks.console->log(ToSpdlog(level), "{}: {}", source, message);
  const std::scoped_lock lock(sinks.mutex);
  for (const LogSink& sink : sinks.others) sink(level, source, message);
}

void SetLogLevel(LogLevel level) { TheSinks().console->set_level(ToSpdlog(level)); }

void AddLogSink(LogSink sink) {
  Sinks& sinks = TheSinks();
  const std::scoped_lock lock(sinks.mutex);
  sinks.others.push_back(std::move(sink));
}

}  // namespace tendon
