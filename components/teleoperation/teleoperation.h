#pragma once

#include <components/arm_interface/arm_payloads.h>
#include <components/teleoperation/joint_tour.h>
#include <components/teleoperation/teleoperation_payloads.h>
#include <tendon/interface/function.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>

namespace arm {

/// Leads any arm through a tour of postures, at 50 Hz. Does nothing until its interface `Robot` is
/// connected; then it starts from the arm's present posture. Records `Target`, `Tracking` and
/// `Limits`, the number of limits that the arm has met. The tour reverses at each limit.
class Teleoperation : public tendon::PeriodicTask {
 public:
  using Configuration = TeleoperationConfiguration;

  /// Throws ConfigurationError if a number of the configuration is invalid.
  explicit Teleoperation(std::string name, const Configuration& configuration = {});

 private:
  void Startup() override { is_leading_ = false; }
  void Run() override;
  void Cleanup() override;
  // The arm may have moved, or another arm may be connected. Starts again from the present posture.
  void OnConnected(tendon::RequiredInterface& /*robot*/) override { is_leading_ = false; }
  void OnDisconnected(tendon::RequiredInterface& /*robot*/) override { is_leading_ = false; }
  void OnResume() override { is_leading_ = false; }

  void SetOut(const JointState& joints);
  void ContinueFrom(const JointState& joints);
  void SendGoal();
  [[nodiscard]] JointVector PostureAt(double time_ahead) const;

  void OnGoalReached() { cycles_to_goal_ = 0; }
  void OnLimitExceeded(const LimitFault& fault);

  tendon::WriteFunction<JointGoal> move_to_;
  tendon::VoidFunction stop_;
  tendon::ReadFunction<JointState> get_joints_;

  JointTour tour_;
  bool is_leading_ = false;
  double time_ = 0.0;       // s on the tour
  double direction_ = 1.0;  // 1, or -1 backwards
  double elapsed_ = 0.0;    // s since the component started to lead
  double turned_ = 0.0;     // s since the tour last reversed
  JointVector detour_{};    // rad from the tour to the arm's posture at the start
  int cycles_to_goal_ = 0;

  Target target_;
  Tracking tracking_;
  std::uint64_t limits_ = 0;
};

}  // namespace arm
