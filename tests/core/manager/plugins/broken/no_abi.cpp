extern "C" void TendonRegisterComponents(void* /*registry*/) {}
