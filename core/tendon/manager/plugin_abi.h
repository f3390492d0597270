#pragma once

#include <cstdint>

/// Identifies the build of a plug-in: the version of these headers and the compiler's binary
/// interface. Every plug-in that includes this header has its own copy of the function. The loader
/// compares the results before the plug-in may register anything.
extern "C" [[gnu::used, gnu::visibility("default")]] inline std::uint64_t
TendonPluginAbi() noexcept {
  constexpr std::uint64_t kMajor = 0;
  constexpr std::uint64_t kMinor = 1;
  constexpr std::uint64_t kCompiler = __GXX_ABI_VERSION;
  constexpr std::uint64_t kStrings = _GLIBCXX_USE_CXX11_ABI;
  return kMajor << 48U | kMinor << 32U | kCompiler << 8U | kStrings;
}
