#pragma once

#include <tendon/base/os/process.h>
#include <tendon/task/periodic_task.h>
#include <tests/system/faults/instruments/journal.h>
#include <tests/system/faults/instruments/numbered.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>

namespace faults {

using namespace std::chrono_literals;

/// Streams numbered rows at 1 kHz, and writes each executed command to the journal.
class Ledger final : public tendon::PeriodicTask {
 public:
  using Configuration = JournalPlace;

  Ledger(std::string name, const Configuration& place)
      : PeriodicTask(std::move(name), 1ms),
        executed_(place.folder, "executed", source_),
        held_(place.folder, "held", source_) {
    constexpr std::size_t kRows = std::size_t{1} << 16U;  // readers may stall for a minute
    state_table().SetLength(kRows);
    state_table().Add(sample_, "Sample");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Ledger::Execute, this, "Execute");
    control.AddCommandWriteReturn(&Ledger::Hold, this, "Hold");
    control.AddCommandVoidReturn(&Ledger::Spawn, this, "Spawn");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    sample_ = MakeNumbered(source_, sample_.number + 1);
  }

  void Execute(const Numbered& command) {
    executed_.Add(std::to_string(command.source) + " " + std::to_string(command.number) + " " +
                  std::to_string(command.check));
  }

  /// Blocks the ledger's thread for this time.
  void Hold(std::uint32_t milliseconds, std::uint32_t& held) {
    held_.Add(std::to_string(milliseconds));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    held = milliseconds;
  }

  /// Starts a program that outlives this process, and returns its pid. A component that starts a
  /// program does not know the sockets of its process, so it cannot close them.
  void Spawn(std::int64_t& child) {
    child = fork();
    if (child != 0) return;
    execlp("sleep", "sleep", "600", nullptr);
    _exit(127);
  }

  const std::uint64_t source_ = tendon::os::RandomNumber();
  Journal executed_;
  Journal held_;
  Numbered sample_;
};

}  // namespace faults
