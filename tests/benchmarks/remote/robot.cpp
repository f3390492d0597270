#include <benchmarks/remote/robot.h>

#include <utility>

namespace tendon::benchmark {

Robot::Robot(std::string name) : SignalTask(std::move(name)), history_(AddStateTable("History")) {
  state_table().Add(joints_, "Joints");
  history_.Add(row_, "Joints");
  history_.SetLength(kRows);
  history_.AdvanceOnlyByHand();
  auto& control = AddProvidedInterface("Control");
  control.AddCommandWrite(&Robot::Move, this, "Move");
  control.AddCommandWrite(&Robot::Record, this, "Record");
  control.AddCommandReadState(state_table(), joints_, "GetJoints");
  control.AddCommandRead(&Robot::GetImage, this, "GetImage", ThreadSafe{});
  control.AddCommandRead(&Robot::shared_image, this, "GetSharedImage", ThreadSafe{});
}

void Robot::Record(const std::uint64_t& rows) {
  const SteadyTime now = SteadyClock().Now();
  for (std::uint64_t i = 0; i < rows; ++i) {
    ++row_[0];
    history_.Advance(now);
  }
}

Desk::Desk(std::string name) : Component(std::move(name)) {
  constexpr std::chrono::seconds kForStalledMachines(10);
  auto& robot = AddRequiredInterface("Robot");
  robot.SetMailboxCapacity(kCapacity);
  robot.SetReadDeadline(kForStalledMachines);
  robot.AddFunction(move, "Move");
  robot.AddFunction(record, "Record");
  robot.AddFunction(get_joints, "GetJoints");
  robot.AddFunction(get_image, "GetImage");
  robot.AddFunction(get_shared_image, "GetSharedImage");
}

}  // namespace tendon::benchmark
