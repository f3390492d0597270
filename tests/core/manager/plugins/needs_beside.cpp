#include <tendon/manager/component_registry.h>

void Gone();

/// Calls into a library that lies beside the plug-in.
extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& /*registry*/) { Gone(); }
