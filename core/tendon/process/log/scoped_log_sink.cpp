#include <tendon/process/log/scoped_log_sink.h>

#include <map>
#include <mutex>
#include <string_view>
#include <utility>

namespace tendon {
namespace {

/// The single log sink, which passes records to all ScopedLogSinks.
class Taps {
 public:
  static Taps& All() {
    static Taps& taps = *new Taps;  // never destroyed, like the log
    return taps;
  }

  void Add(const ScopedLogSink* tap, LogSink sink) {
    const std::scoped_lock lock(mutex_);
    sinks_.emplace(tap, std::move(sink));
  }
  void Remove(const ScopedLogSink* tap) {
    const std::scoped_lock lock(mutex_);
    sinks_.erase(tap);
  }

 private:
  Taps() {
    AddLogSink([this](LogLevel level, std::string_view source, std::string_view text) {
      const std::scoped_lock lock(mutex_);
      for (const auto& [tap, sink] : sinks_) sink(level, source, text);
    });
  }

  std::mutex mutex_;
  std::map<const ScopedLogSink*, LogSink> sinks_;
};

}  // namespace

ScopedLogSink::ScopedLogSink(LogSink sink) { Taps::All().Add(this, std::move(sink)); }

ScopedLogSink::~ScopedLogSink() { Taps::All().Remove(this); }

}  // namespace tendon
