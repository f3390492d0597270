#pragma once

#include <docs/tutorials/kitchen/payloads.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>
#include <utility>

namespace kitchen {

using namespace std::chrono_literals;

/// Orders one thing after the other, each when the one before is done.
class Cook final : public tendon::PeriodicTask {
 public:
  explicit Cook(std::string name) : PeriodicTask(std::move(name), 50ms) {
    state_table().Add(batches_, "Batches");
    auto& oven = AddRequiredInterface("Oven");
    oven.AddFunction(bake_, "Bake");
    oven.AddEventHandlerWrite(&Cook::OnDone, this, "Done");
  }

 private:
  void OnConnected(tendon::RequiredInterface& /*oven*/) override { cycles_to_order_ = 0; }
  void Run() override {
    ProcessQueuedCommands();
    if (--cycles_to_order_ > 0) return;
    if (bake_({.temperature = 180.0, .duration = 0.5})) cycles_to_order_ = kTimeout;
  }
  void OnDone(const Batch& batch) {
    batches_ = batch.number;
    cycles_to_order_ = 0;
  }

  static constexpr int kTimeout = 600;  // cycles; an event is lost with the process that raises it
  tendon::WriteFunction<Recipe> bake_;
  int cycles_to_order_ = 0;
  std::uint64_t batches_ = 0;
};

}  // namespace kitchen
