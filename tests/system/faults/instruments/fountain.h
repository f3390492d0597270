#pragma once

#include <tendon/base/os/process.h>
#include <tendon/task/periodic_task.h>
#include <tests/system/faults/instruments/numbered.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace faults {

/// Streams numbered rows. The rows are so large, and are kept for so short a time, that a slow
/// reader misses some.
class Fountain final : public tendon::PeriodicTask {
 public:
  explicit Fountain(std::string name)
      : PeriodicTask(std::move(name), std::chrono::milliseconds(2)) {
    constexpr std::size_t kRows = 256;
    state_table().SetLength(kRows);
    state_table().Add(sample_, "Sample");
    state_table().Add(ballast_, "Ballast");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    sample_ = MakeNumbered(source_, sample_.number + 1);
  }

  const std::uint64_t source_ = tendon::os::RandomNumber();
  Numbered sample_;
  std::array<std::uint64_t, 1024> ballast_{};
};

}  // namespace faults
