#pragma once

#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/interface/event.h>
#include <tendon/task/periodic_task.h>
#include <tests/system/faults/instruments/numbered.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace faults {

/// Streams numbered rows at 1 kHz. Its table holds about a second of them. Raises an event with
/// each hundredth sample, and logs the number of this sample.
class Herald final : public tendon::PeriodicTask {
 public:
  explicit Herald(std::string name) : PeriodicTask(std::move(name), std::chrono::milliseconds(1)) {
    state_table().Add(sample_, "Sample");
    AddProvidedInterface("Control").AddEvent(passed_, "Passed");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    sample_ = MakeNumbered(source_, sample_.number + 1);
    if (sample_.number % 100 != 0) return;
    passed_(sample_);
    tendon::Log(tendon::LogLevel::kInfo, name(), "passed " + std::to_string(sample_.number));
  }

  const std::uint64_t source_ = tendon::os::RandomNumber();
  Numbered sample_;
  tendon::WriteEvent<Numbered> passed_;
};

}  // namespace faults
