#pragma once

#include <cstdint>
#include <string>

namespace tendon {

/// Identifies the binary interface of C++ for which a source is compiled: programs and plug-ins of
/// one number may share objects. g++ and clang implement the same interface, so they have one
/// number: the revisions that `__GXX_ABI_VERSION` counts after 1002, with which clang stays, change
/// nothing that payloads and components use.
inline constexpr std::uint64_t kCxxAbi = __GXX_ABI_VERSION < 1002 ? __GXX_ABI_VERSION : 1002;

/// 1 if std::string is the one of C++11, and 2 more if containers are those of the debug mode.
inline constexpr std::uint64_t kCxxLibraryAbi = _GLIBCXX_USE_CXX11_ABI
#ifdef _GLIBCXX_DEBUG
                                                + 2
#endif
    ;

}  // namespace tendon
