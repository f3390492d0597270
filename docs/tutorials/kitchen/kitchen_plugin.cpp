#include <docs/tutorials/kitchen/cook.h>
#include <docs/tutorials/kitchen/oven.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<kitchen::Oven>("Oven");
  registry.Add<kitchen::Cook>("Cook");
}
