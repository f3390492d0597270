#include <tendon/manager/component_registry.h>

extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& /*registry*/) { throw 7; }
