#include <cstdint>

extern "C" std::uint64_t TendonPluginAbi() {
  return std::uint64_t{7} << 48U | std::uint64_t{2} << 32U | std::uint64_t{1011} << 8U;
}

extern "C" void TendonRegisterComponents(void* /*registry*/) {}
