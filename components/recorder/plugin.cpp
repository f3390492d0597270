#include <components/recorder/recorder.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<recorder::Recorder>("Recorder");
}
