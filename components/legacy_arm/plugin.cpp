#include <components/legacy_arm/legacy_arm.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<legacy::LegacyArm>("LegacyArm");
}
