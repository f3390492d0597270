#include <tendon/manager/component_registry.h>

class Lamp final : public tendon::Component {
 public:
  explicit Lamp(std::string name) : Component(std::move(name)) {}
};

// The header exports this function with C linkage.
void TendonRegisterComponents(tendon::ComponentRegistry& registry) { registry.Add<Lamp>("Lamp"); }
