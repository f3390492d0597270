#include <tendon/process/log/log_queue.h>

#include <tendon/base/text.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tendon {
namespace {

message::LogRecord RecordOf(LogLevel level, std::string_view source, std::string_view text) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {.time = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count(),
          .level = level,
          .process = {},
          .source = Printable(source, LogLimiter::kLongestSource),
          .text = Printable(text, LogQueue::kLongestText)};
}

}  // namespace

bool LogQueue::Add(LogLevel level, std::string_view source, std::string_view text) {
  const std::scoped_lock lock(mutex_);
  if (limiter_.Admit(source, level, clock_.Now())) Push({.record = RecordOf(level, source, text)});
  const bool had_news = has_news_.Get();
  has_news_.Set(true);
  return !had_news;
}

std::vector<message::LogRecord> LogQueue::Take(std::size_t most, SteadyTime now) {
  const std::scoped_lock lock(mutex_);
  for (const auto& [source, level, count] : limiter_.TakeSuppressed(now)) {
    const std::string text = "suppressed " + Counted(count, "record", "records") + ": too many";
    Push({.record = RecordOf(level, source, text), .stands_for = count});
  }
  std::vector<message::LogRecord> taken;
  taken.reserve(std::min(most, records_.size()) + 1);  // no record is lost if this throws
  if (lost_ > 0) {
    taken.push_back(RecordOf(LogLevel::kWarning, "log",
                             std::to_string(std::exchange(lost_, 0)) +
                                 " older records are lost: more than " + std::to_string(kCapacity) +
                                 " waited to be sent"));
  }
  for (std::size_t left = std::min(most, records_.size()); left > 0; --left) {
    taken.push_back(std::move(records_.front().record));
    records_.pop_front();
  }
  has_news_.Set(!records_.empty() || limiter_.owes());
  return taken;
}

void LogQueue::Push(QueuedRecord waiting) {
  if (records_.size() == kCapacity) {
    lost_ += records_.front().stands_for;
    records_.pop_front();
  }
  records_.push_back(std::move(waiting));
}

}  // namespace tendon
