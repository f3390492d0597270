#pragma once

#include <docs/tutorials/kitchen/payloads.h>
#include <tendon/task/periodic_task.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace kitchen {

using namespace std::chrono_literals;

/// Heats up for an order, bakes it, says that it is done and cools down again.
class Oven final : public tendon::PeriodicTask {
 public:
  using Configuration = OvenConfiguration;

  explicit Oven(std::string name, const Configuration& configuration = {})
      : PeriodicTask(std::move(name), 10ms), heating_(configuration.heating) {
    state_table().Add(temperature_, "Temperature");
    auto& control = AddProvidedInterface("Control");
    control.AddCommandWrite(&Oven::Bake, this, "Bake");
    control.AddCommandVoid(&Oven::Grill, this, "Grill").ExpiresAfter(500ms, &Oven::EndGrill, this);
    control.AddCommandReadState(state_table(), temperature_, "GetTemperature");
    control.AddEvent(done_, "Done");
  }

 private:
  void Run() override {
    ProcessQueuedCommands();
    const double rest = is_grilling_ ? kGrillTemperature : kRoomTemperature;
    const double goal = is_baking_ ? recipe_.temperature : rest;
    const double step = heating_ * period();
    temperature_ += std::clamp(goal - temperature_, -step, step);
    if (!is_baking_ || temperature_ < goal) return;
    baked_ += period();
    if (baked_ < recipe_.duration) return;
    is_baking_ = false;
    done_({.number = ++batches_, .temperature = temperature_});
  }
  void OnResume() override { is_baking_ = false; }
  void Grill() { is_grilling_ = true; }
  void EndGrill() { is_grilling_ = false; }
  void Bake(const Recipe& recipe) {
    recipe_ = recipe;
    is_baking_ = true;
    baked_ = 0.0;
  }

  static constexpr double kRoomTemperature = 20.0;    // degC
  static constexpr double kGrillTemperature = 250.0;  // degC
  const double heating_;                              // K/s
  double temperature_ = kRoomTemperature;             // degC
  bool is_baking_ = false;
  bool is_grilling_ = false;
  Recipe recipe_;
  double baked_ = 0.0;  // s
  std::uint64_t batches_ = 0;
  tendon::WriteEvent<Batch> done_;
};

}  // namespace kitchen
