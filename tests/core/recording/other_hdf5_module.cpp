#include <cstdlib>

/// A module of another build: to call its exporter would end the test.
extern "C" const char* TendonHdf5Build();
extern "C" void TendonExportHdf5();

const char* TendonHdf5Build() { return "module 0"; }
void TendonExportHdf5() { std::abort(); }
