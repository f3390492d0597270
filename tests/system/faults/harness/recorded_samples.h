#pragma once

#include <tendon/process/telemetry_client.h>
#include <tendon/recording/mcap/reader.h>
#include <tests/system/faults/instruments/numbered.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace faults {

/// Follows the samples of a table, which have consecutive numbers.
class NewestNumber final : public tendon::RowSink {
 public:
  /// Returns the number of the newest sample that has arrived; 0 before the first.
  [[nodiscard]] std::uint64_t number() const {
    const std::scoped_lock lock(mutex_);
    return number_;
  }

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override {}
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& /*reason*/) override {}

  mutable std::mutex mutex_;
  std::uint64_t number_ = 0;
};

/// Whether samples may be missing in a file.
enum class Gaps { kNone, kReported };

/// Returns the numbers of the samples of `table` in a file. Expects that they are consecutive. With
/// Gaps::kReported, samples may be missing, but only as many as the file reports as lost.
std::vector<std::uint64_t> NumbersIn(tendon::mcap::Reader& reader, const std::string& table,
                                     Gaps gaps);

/// Returns the numbers of the events with samples on a topic of a file.
std::vector<std::uint64_t> EventsIn(tendon::mcap::Reader& reader, const std::string& topic);

/// Returns the texts of the log records of a component in a file.
std::vector<std::string> LogIn(tendon::mcap::Reader& reader, const std::string& component);

}  // namespace faults
