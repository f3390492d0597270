#include <components/host_monitor/host_monitor.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<host::HostMonitor>("HostMonitor");
}
