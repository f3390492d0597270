#include <tendon/manager/component_registry.h>

void Gone();

/// Calls a library in the same folder as the plug-in.
extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& /*registry*/) { Gone(); }
