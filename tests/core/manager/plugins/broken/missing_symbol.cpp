namespace lamp {
void SwitchOn(int level);
}

extern "C" void TendonRegisterComponents(void* /*registry*/) { lamp::SwitchOn(1); }
