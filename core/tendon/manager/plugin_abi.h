#pragma once

#include <tendon/base/cxx_abi.h>

#include <cstdint>

/// Returns a number that identifies the build of a plug-in: the version of these headers and the
/// ABI of the compiler. Every plug-in that includes this header has its own copy of the function.
/// The loader compares the result with its own before the plug-in may register anything.
extern "C" [[gnu::used, gnu::visibility("default")]] inline std::uint64_t
TendonPluginAbi() noexcept {
  constexpr std::uint64_t kMajor = 0;
  constexpr std::uint64_t kMinor = 1;
  return kMajor << 48U | kMinor << 32U | tendon::kCxxAbi << 8U | tendon::kCxxLibraryAbi;
}
