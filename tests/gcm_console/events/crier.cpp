#include <tendon/manager/component_registry.h>
#include <tendon/task/periodic_task.h>

#include <cstdint>
#include <string>
#include <utility>

namespace {

using namespace std::chrono_literals;

/// Raises as many events at once as it is asked for.
class Crier final : public tendon::PeriodicTask {
 public:
  explicit Crier(std::string name) : PeriodicTask(std::move(name), 1ms) {
    auto& voice = AddProvidedInterface("Voice");
    voice.AddCommandWrite(&Crier::Cry, this, "Cry");
    voice.AddCommandVoid(&Crier::Fall, this, "Fall");
    voice.AddEvent(cried_, "Cried");
    voice.AddEvent(fell_, "Fell");
  }
  ~Crier() override { Join(); }

 private:
  void Run() override { ProcessQueuedCommands(); }
  void Cry(const std::int32_t& times) {
    for (std::int32_t i = 1; i <= times; ++i) cried_(i);
  }
  void Fall() { fell_(); }

  tendon::WriteEvent<std::int32_t> cried_;
  tendon::VoidEvent fell_;
};

}  // namespace

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Crier>("Crier");
}
