#include <docs/tutorials/wave/tuner.h>
#include <docs/tutorials/wave/wave.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<Wave>("Wave");
  registry.Add<Tuner>("Tuner");
}
