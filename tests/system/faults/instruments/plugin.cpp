#include <tendon/manager/component_registry.h>
#include <tests/system/faults/instruments/client.h>
#include <tests/system/faults/instruments/ledger.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
  registry.Add<faults::Client>("Client");
  registry.Add<faults::Ledger>("Ledger");
}
