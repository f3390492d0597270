#pragma once

#include <tendon/base/os/process.h>
#include <tendon/interface/function.h>
#include <tendon/task/periodic_task.h>
#include <tests/system/faults/instruments/journal.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace faults {

/// Configuration of a drive and its driver.
struct DriveSettings {
  std::string folder;
  double cycle = 0.0;   // s of work in each cycle
  bool floods = false;  // true: sends commands until one is refused
};

}  // namespace faults

template <>
inline constexpr auto tendon::kPayload<faults::DriveSettings> = tendon::Describe(
    "faults.DriveSettings", tendon::Field{"folder", &faults::DriveSettings::folder},
    tendon::Field{"cycle", &faults::DriveSettings::cycle, "s"},
    tendon::Field{"floods", &faults::DriveSettings::floods});

namespace faults {

using namespace std::chrono_literals;

/// Moves at the speed of the last command. Writes each start and each executed stop to the journal.
class Drive final : public tendon::PeriodicTask {
 public:
  using Configuration = DriveSettings;

  Drive(std::string name, const Configuration& settings)
      : PeriodicTask(std::move(name), 2ms),
        work_(settings.cycle),
        moved_(settings.folder, "moved", source_),
        stopped_(settings.folder, "stopped", source_) {
    state_table().Add(velocity_, "Velocity");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Drive::Move, this, "Move");
    control.AddCommandVoid(&Drive::Stop, this, "Stop");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    std::this_thread::sleep_for(work_);
  }
  void Move(const double& velocity) {
    if (velocity_ == 0.0) moved_.Add("moved");
    velocity_ = velocity;
  }
  void Stop() {
    velocity_ = 0.0;
    stopped_.Add("stopped");
  }

  const std::chrono::duration<double> work_;
  const std::uint64_t source_ = tendon::os::RandomNumber();
  Journal moved_;
  Journal stopped_;
  double velocity_ = 0.0;
};

/// Moves a drive faster and faster. Stops the drive in its own Cleanup(), and writes the outcome of
/// the stop to the journal.
class Driver final : public tendon::PeriodicTask {
 public:
  using Configuration = DriveSettings;

  Driver(std::string name, const Configuration& settings)
      : PeriodicTask(std::move(name), 2ms),
        floods_(settings.floods),
        ended_(settings.folder, "ended", tendon::os::RandomNumber()) {
    state_table().Add(refused_, "Refused");
    auto& drive = AddRequiredInterface("Drive");
    drive.AddFunction(move_, "Move");
    drive.AddFunction(stop_, "Stop");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    tendon::Status moved = move_(++velocity_);
    while (floods_ && moved) moved = move_(++velocity_);
    if (moved == tendon::Status::kQueueFull) ++refused_;
  }
  void Cleanup() override { ended_.Add(std::string(ToString(stop_()))); }

  const bool floods_;
  Journal ended_;
  std::uint64_t refused_ = 0;
  double velocity_ = 0.0;
  tendon::WriteFunction<double> move_;
  tendon::VoidFunction stop_;
};

}  // namespace faults
