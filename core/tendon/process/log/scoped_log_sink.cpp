#include <tendon/process/log/scoped_log_sink.h>

#include <map>
#include <mutex>
#include <string_view>
#include <utility>

namespace tendon {
namespace {

/// The single log sink, which passes records to all ScopedLogSinks.
class SinkList {
 public:
  static SinkList& All() {
    static SinkList& list = *new SinkList;  // never destroyed, like the log
    return list;
  }

  void Add(const ScopedLogSink* owner, LogSink sink) {
    const std::scoped_lock lock(mutex_);
    sinks_.emplace(owner, std::move(sink));
  }
  void Remove(const ScopedLogSink* owner) {
    const std::scoped_lock lock(mutex_);
    sinks_.erase(owner);
  }

 private:
  SinkList() {
    AddLogSink([this](LogLevel level, std::string_view source, std::string_view text) {
      const std::scoped_lock lock(mutex_);
      for (const auto& [owner, sink] : sinks_) sink(level, source, text);
    });
  }

  std::mutex mutex_;
  std::map<const ScopedLogSink*, LogSink> sinks_;
};

}  // namespace

ScopedLogSink::ScopedLogSink(LogSink sink) { SinkList::All().Add(this, std::move(sink)); }

ScopedLogSink::~ScopedLogSink() { SinkList::All().Remove(this); }

}  // namespace tendon
