#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <tendon/base/clock.h>
#include <tendon/process/telemetry_client.h>

#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace faults {

/// The highest values that any joint has reached.
struct Peak {
  double speed = 0.0;         // rad/s
  double acceleration = 0.0;  // rad/s^2
  double stall = 0.0;         // s: the longest pause between two cycles; the arm does not notice it
};

/// Returns a line for the output of a test.
std::string ToString(const Peak& peak);

/// Reads every row of an arm's joints, and computes the motion of the arm.
class MotionChecker final : public tendon::RowSink {
 public:
  /// Returns the peak since the last call, and starts a new measurement.
  Peak TakePeak();
  [[nodiscard]] arm::JointState joints() const;
  /// Returns the speed in the newest row; 0 if there is none.
  [[nodiscard]] double speed() const;
  /// Returns the time of the last row in which the arm moved, by the clock of this host.
  [[nodiscard]] tendon::SteadyTime last_motion() const;
  /// Returns the number of rows that have arrived.
  [[nodiscard]] std::size_t rows() const;

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override {}
  void OnRows(const tendon::RowBatch& batch) override;
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
