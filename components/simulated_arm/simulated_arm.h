#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <components/simulated_arm/arm_configuration.h>
#include <components/simulated_arm/arm_motion.h>
#include <tendon/interface/event.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <random>
#include <string>

namespace arm {

/// A simulated arm of seven joints, at 1 kHz. It offers `Control` as arm_interface describes it,
/// keeps the limits of its configuration, and records `Joints` (measured), `Goal` and `Refused`
/// (the number of invalid goals).
///
/// Every cycle is one millisecond of motion, regardless of the clock, so a late cycle causes no
/// jump.
class SimulatedArm : public tendon::PeriodicTask {
 public:
  using Configuration = ArmConfiguration;

  /// Throws ConfigurationError if a number of the configuration is invalid.
  explicit SimulatedArm(std::string name, const Configuration& configuration = {});

 private:
  void Startup() override;
  void Run() override;
  /// Holds its position, because earlier commands are outdated.
  void OnResume() override;

  void MoveTo(const JointGoal& goal);
  void MoveAt(const JointVelocity& velocity);
  /// Stops, unless another command arrived meanwhile.
  void EndMoveAt();
  void Stop() { motion_.Stop(); }
  void Measure();

  ArmMotion motion_;
  std::minstd_rand random_;
  std::normal_distribution<double> normal_;
  double noise_;  // rad

  JointState joints_;
  JointGoal goal_;
  std::uint64_t refused_ = 0;
  tendon::WriteEvent<LimitFault> limit_exceeded_;
  tendon::VoidEvent goal_reached_;
};

}  // namespace arm
