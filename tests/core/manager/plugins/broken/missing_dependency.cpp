void Gone();

extern "C" void TendonRegisterComponents(void* /*registry*/) { Gone(); }
