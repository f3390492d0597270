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

/// An arm of seven joints that exists only here, at 1 kHz. It offers `Control` as arm_interface
/// describes it, keeps the limits of its configuration, and records `Joints` (measured), `Goal`
/// and `Refused` (goals that made no sense).
///
/// Every cycle is one millisecond of its motion, whatever the clock says: a late cycle does not
/// make it jump.
class SimulatedArm : public tendon::PeriodicTask {
 public:
  using Configuration = ArmConfiguration;

  /// ConfigurationError when a number of the configuration makes no sense.
  explicit SimulatedArm(std::string name, const Configuration& configuration = {});

 private:
  void Startup() override;
  void Run() override;
  /// It holds where it is: what it was told before was meant for the world as it was then.
  void OnResume() override;

  void MoveTo(const JointGoal& goal);
  void MoveAt(const JointVelocity& velocity);
  /// Unless something else was told meanwhile.
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
