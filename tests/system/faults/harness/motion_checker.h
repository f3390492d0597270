#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <tendon/base/clock.h>
#include <tendon/process/telemetry_client.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace faults {

/// The greatest that any joint has reached.
struct Peak {
  double speed = 0.0;         // rad/s
  double acceleration = 0.0;  // rad/s^2
  double stall = 0.0;         // s: the longest between two cycles, which the arm sees as no time
};

/// For people.
std::string ToString(const Peak& peak);

/// Reads every row of an arm's joints, and computes how the arm has moved.
class MotionChecker final : public tendon::RowSink {
 public:
  /// Since the last time it was asked, and forgets.
  Peak TakePeak();
  [[nodiscard]] arm::JointState joints() const;
  /// Of the newest row; 0 where there is none.
  [[nodiscard]] double speed() const;
  /// When the arm was last in motion, by the clock of this host.
  [[nodiscard]] tendon::SteadyTime last_motion() const;
  /// Rows that have come.
  [[nodiscard]] std::size_t rows() const;

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override {}
  std::size_t OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& /*reason*/) override {}

  mutable std::mutex mutex_;
  std::size_t rows_ = 0;
  std::optional<std::uint64_t> last_tick_;
  std::int64_t last_time_ = 0;  // ns
  arm::JointState joints_;
  Peak peak_;
  tendon::SteadyTime last_motion_{};
};

}  // namespace faults
