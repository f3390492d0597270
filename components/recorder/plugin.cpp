#include <components/recorder/recorder_component.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<recorder::RecorderComponent>("Recorder");
}
