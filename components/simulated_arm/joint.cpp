#include <components/simulated_arm/joint.h>

#include <algorithm>
#include <cmath>

namespace arm {
namespace {

constexpr double kEntered = 1e-3;  // rad; at this distance from the end, the limit is reached
constexpr double kLeft = 1e-2;     // rad; at this distance from the end, the limit is left

/// Returns the highest safe velocity in the next step towards an end that is `distance` rad away.
/// This is the velocity v for which v * step + v^2 / (2 acceleration) = distance.
double FastestTowards(double distance, double acceleration, double step) {
  return acceleration * (std::sqrt(step * step + 2.0 * distance / acceleration) - step);
}

}  // namespace

Joint::Joint(const JointLimits& limits, double bandwidth, double position)
    : limits_(limits), bandwidth_(bandwidth), point_{position, 0.0, 0.0} {
  WatchLimits();
}

void Joint::Step(const JointPoint& reference, double step) {
  auto& [position, velocity, acceleration] = point_;
  const double wanted = reference.acceleration +
                        2.0 * bandwidth_ * (reference.velocity - velocity) +
                        bandwidth_ * bandwidth_ * (reference.position - position);

  const double change = limits_.acceleration * step;
  const double up = FastestTowards(limits_.upper - position, limits_.acceleration, step);
  const double down = FastestTowards(position - limits_.lower, limits_.acceleration, step);
  const double fastest = std::min({velocity + change, limits_.velocity, up});
  const double slowest = std::max({velocity - change, -limits_.velocity, -down});

  const double next = std::max(slowest, std::min(velocity + wanted * step, fastest));
  acceleration = (next - velocity) / step;
  position = std::clamp(position + next * step, limits_.lower, limits_.upper);
  velocity = next;
  WatchLimits();
}

void Joint::Rest() {
  point_.velocity = 0.0;
  point_.acceleration = 0.0;
  has_entered_limit_ = false;
}

void Joint::WatchLimits() {
  const double distance =
      std::min(point_.position - limits_.lower, limits_.upper - point_.position);
  has_entered_limit_ = !is_at_limit_ && distance <= kEntered;
  if (has_entered_limit_) is_at_limit_ = true;
  if (distance >= kLeft) is_at_limit_ = false;
}

}  // namespace arm
