#pragma once

#include <tendon/base/log.h>

#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tendon_test {

/// The log of one source since this object was created.
class LogRecord {
 public:
  explicit LogRecord(std::string source)
      : source_(std::move(source)), begin_(Everything().Size()) {}

  [[nodiscard]] std::vector<std::string> texts() const {
    return Everything().Since(begin_, source_);
  }

 private:
  class Log {
   public:
    Log() {
      tendon::AddLogSink([this](tendon::LogLevel, std::string_view source, std::string_view text) {
        const std::scoped_lock lock(mutex_);
        records_.emplace_back(source, text);
      });
    }
    std::size_t Size() {
      const std::scoped_lock lock(mutex_);
      return records_.size();
    }
    std::vector<std::string> Since(std::size_t begin, const std::string& source) {
      const std::scoped_lock lock(mutex_);
      std::vector<std::string> texts;
      for (std::size_t i = begin; i < records_.size(); ++i) {
        if (records_[i].first == source) texts.push_back(records_[i].second);
      }
      return texts;
    }

   private:
    std::mutex mutex_;
    std::vector<std::pair<std::string, std::string>> records_;
  };
  static Log& Everything() {
    static Log& log = *new Log;  // a sink lives as long as the process
    return log;
  }

  std::string source_;
  std::size_t begin_;
};

}  // namespace tendon_test
