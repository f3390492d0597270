#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <chrono>

namespace lamp {

struct Configuration {
  double brightness = 0.5;
};

class Lamp final : public tendon::PeriodicTask {
 public:
  using Configuration = lamp::Configuration;

  Lamp(std::string name, const Configuration& configuration)
      : PeriodicTask(std::move(name), std::chrono::milliseconds(10)),
        brightness_(configuration.brightness) {
    state_table().Add(brightness_, "Brightness");
  }

 private:
  void Run() override { ProcessQueuedCommands(); }

  double brightness_;
};

}  // namespace lamp

template <>
inline constexpr auto tendon::kPayload<lamp::Configuration> = tendon::Describe(
    "lamp.Configuration",
    tendon::Field{"brightness", &lamp::Configuration::brightness}.Within(0, 1).Help("1 is full."));

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<lamp::Lamp>("Lamp");
}
