#pragma once

#include <tendon/base/os/process.h>
#include <tendon/interface/function.h>
#include <tendon/task/continuous_task.h>
#include <tests/system/faults/instruments/journal.h>
#include <tests/system/faults/instruments/numbered.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace faults {

using namespace std::chrono_literals;

/// Sends numbered commands to a ledger, one after another. Writes a line to the journal before each
/// command, and a line with its reported outcome afterwards.
class Client final : public tendon::ContinuousTask {
 public:
  using Configuration = JournalPlace;

  Client(std::string name, const Configuration& place)
      : ContinuousTask(std::move(name)), given_(place.folder, "given", source_) {
    auto& ledger = AddRequiredInterface("Ledger");
    ledger.AddFunction(execute_, "Execute");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    const Numbered command = MakeNumbered(source_, ++number_);
    const std::string number = std::to_string(number_);
    given_.Add(number + " given");
    const tendon::Status status = execute_.Wait(command, 200ms);
    given_.Add(number + " " + std::string(ToString(status)));
    std::this_thread::sleep_for(status ? 1ms : 5ms);
  }

  const std::uint64_t source_ = tendon::os::RandomNumber();
  Journal given_;
  std::uint64_t number_ = 0;
  tendon::WriteFunction<Numbered> execute_;
};

}  // namespace faults
