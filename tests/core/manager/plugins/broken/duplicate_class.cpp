#include <tendon/manager/component_registry.h>

class Lamp final : public tendon::Component {
 public:
  explicit Lamp(std::string name) : Component(std::move(name)) {}
};

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Lamp>("Lamp");
  registry.Add<Lamp>("Lamp");
}
