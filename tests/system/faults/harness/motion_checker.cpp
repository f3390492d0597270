#include "system/faults/harness/motion_checker.h"

#include <tendon/payload/codec.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace faults {
namespace {

constexpr double kCycle = 1e-3;   // s; one cycle of an arm
constexpr double kMoving = 1e-3;  // rad/s

double SpeedOf(const arm::JointState& joints) {
  double fastest = 0.0;
  for (const double one : joints.velocity) fastest = std::max(fastest, std::abs(one));
  return fastest;
}

}  // namespace

std::string ToString(const Peak& peak) {
  return std::to_string(peak.speed) + " rad/s, " + std::to_string(peak.acceleration) +
         " rad/s^2, stalls of " + std::to_string(peak.stall) + " s";
}

Peak MotionChecker::TakePeak() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(peak_, {});
}

arm::JointState MotionChecker::joints() const {
  const std::scoped_lock lock(mutex_);
  return joints_;
}

double MotionChecker::speed() const { return SpeedOf(joints()); }

tendon::SteadyTime MotionChecker::last_motion() const {
  const std::scoped_lock lock(mutex_);
  return last_motion_;
}

std::size_t MotionChecker::rows() const {
  const std::scoped_lock lock(mutex_);
  return rows_;
}

void MotionChecker::OnRows(const tendon::RowBatch& batch) {
  const std::scoped_lock lock(mutex_);
  for (std::size_t row = 0; row < batch.count; ++row) {
    arm::JointState joints;
    if (!tendon::Decode(batch.cell(row, 0), joints)) continue;
    const std::uint64_t tick = batch.ticks[row];
    const double speed = SpeedOf(joints);
    peak_.speed = std::max(peak_.speed, speed);
    for (std::size_t joint = 0; last_tick_ == tick - 1 && joint < arm::kJoints; ++joint) {
      const double change = joints.velocity[joint] - joints_.velocity[joint];
      peak_.acceleration = std::max(peak_.acceleration, std::abs(change) / kCycle);
    }
    if (last_tick_ == tick - 1) {
      peak_.stall =
          std::max(peak_.stall, static_cast<double>(batch.times[row] - last_time_) * 1e-9);
    }
    last_time_ = batch.times[row];
    if (speed > kMoving)
      last_motion_ = tendon::SteadyTime(std::chrono::nanoseconds(batch.times[row]));
    last_tick_ = tick;
    joints_ = joints;
    ++rows_;
  }
}

}  // namespace faults
