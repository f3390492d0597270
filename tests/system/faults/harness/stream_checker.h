#pragma once

#include <tendon/process/telemetry_client.h>
#include <tests/system/faults/instruments/numbered.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace faults {

/// Reads the stream of a ledger's samples. Finds lost, repeated and damaged samples by the numbers
/// in the data.
class StreamChecker final : public tendon::RowSink {
 public:
  struct Verdict {
    std::uint64_t received = 0;
    std::uint64_t missing = 0;   ///< numbers that never arrived although the ledger did not restart
    std::uint64_t counted = 0;   ///< losses that the stream itself reported
    std::uint64_t repeated = 0;  ///< numbers or ticks that arrived twice or went back
    std::uint64_t damaged = 0;   ///< samples with a wrong check sum
    std::vector<std::string> stale;  ///< the reasons of all reports that rows have stopped
    std::uint64_t subscriptions = 0;
    std::uint64_t ledgers = 0;
  };

  [[nodiscard]] Verdict verdict() const;
  [[nodiscard]] std::uint64_t received() const { return verdict().received; }

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;
  void Take(const Numbered& sample);

  mutable std::mutex mutex_;
  Verdict verdict_;
  std::optional<std::uint64_t> last_tick_;  // the last tick of this subscription
  std::optional<Numbered> last_;
};

/// Returns a line for the output of a test: "12345 rows, 0 missing, ..."
std::string ToString(const StreamChecker::Verdict& verdict);

}  // namespace faults
