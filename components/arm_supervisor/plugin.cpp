#include <components/arm_supervisor/arm_supervisor.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<arm::ArmSupervisor>("ArmSupervisor");
}
