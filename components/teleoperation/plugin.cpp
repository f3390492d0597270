#include <components/teleoperation/teleoperation.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<arm::Teleoperation>("Teleoperation");
}
