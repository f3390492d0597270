#pragma once

#include <tendon/gcm/client.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace tendon::test {

/// Stores the log that a viewer receives.
class LogKeeper final : public GcmListener {
 public:
  void OnSnapshot(const Catalogue& /*catalogue*/) override {}
  void OnChanges(const std::vector<CatalogueChange>& /*changes*/) override {}
  void OnGcmLost(const Error& /*reason*/) override {}
  void OnLog(const LogBatch& batch) override {
    const std::scoped_lock lock(mutex_);
    records_.insert(records_.end(), batch.records.begin(), batch.records.end());
    lost_ += batch.lost;
    is_current_ = batch.is_current;
  }

  /// The records of a process, or of one of its sources if `source` is given.
  [[nodiscard]] std::vector<message::LogRecord> Of(const std::string& process,
                                                   const std::string& source = "") const {
    const std::scoped_lock lock(mutex_);
    std::vector<message::LogRecord> some;
    for (const message::LogRecord& record : records_) {
      const bool is_wanted = source.empty() || record.source == source;
      if (record.process == process && is_wanted) some.push_back(record);
    }
    return some;
  }
  [[nodiscard]] std::uint64_t lost() const {
    const std::scoped_lock lock(mutex_);
    return lost_;
  }
  [[nodiscard]] bool is_current() const {
    const std::scoped_lock lock(mutex_);
    return is_current_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<message::LogRecord> records_;
  std::uint64_t lost_ = 0;
  bool is_current_ = false;
};

}  // namespace tendon::test
