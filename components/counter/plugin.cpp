#include <components/counter/counter.h>
#include <components/counter/counter_client.h>
#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<counter::Counter>("Counter");
  registry.Add<counter::CounterClient>("CounterClient");
}
