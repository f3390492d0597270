#pragma once

#include <cstdint>
#include <string>

namespace tendon {

/// Identifies the C++ ABI for which a source file is compiled. Programs and plug-ins with the same
/// number can share objects. g++ and clang get the same number: clang reports 1002 as
/// `__GXX_ABI_VERSION`, and the later ABI versions that g++ reports do not affect payloads and
/// components.
inline constexpr std::uint64_t kCxxAbi = __GXX_ABI_VERSION < 1002 ? __GXX_ABI_VERSION : 1002;

/// 1 if std::string has the layout of C++11, plus 2 if containers are in debug mode.
inline constexpr std::uint64_t kCxxLibraryAbi = _GLIBCXX_USE_CXX11_ABI
#ifdef _GLIBCXX_DEBUG
                                                + 2
#endif
    ;

}  // namespace tendon
