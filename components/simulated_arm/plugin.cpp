#include <components/simulated_arm/simulated_arm.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<arm::SimulatedArm>("SimulatedArm");
}
