#pragma once

#include <tendon/base/cxx_abi.h>
#include <tendon/payload/payload.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <typeinfo>

namespace tendon {

/// A hash of the memory layout of a payload: its size, its alignment, the offset of every field,
/// the C++ types in it, and the ABI of C++ and its library. Two plug-ins may pass values of a type
/// by pointer if both have the same fingerprint and the same layout for it. 0 means that the code
/// has only
/// encoded bytes, as a proxy does.
using Layout = std::uint64_t;

namespace layout {

inline constexpr Layout kNone = 0;

constexpr Layout Mix(Layout hash, std::uint64_t value) {
  constexpr std::uint64_t kPrime = 0x100000001b3;  // of FNV-1a
  return (hash ^ value) * kPrime;
}

constexpr Layout Mix(Layout hash, std::string_view text) {
  for (const char c : text) hash = Mix(hash, static_cast<unsigned char>(c));
  return hash;
}

template <Payload T>
Layout Of(Layout hash) {
  hash = Mix(Mix(hash, sizeof(T)), alignof(T));
  // The hash needs the C++ type. Otherwise seconds and milliseconds would have the same hash, and
  // so would row-major and column-major matrices.
  if constexpr (!payload::Structure<T>) hash = Mix(hash, std::string_view(typeid(T).name()));
  if constexpr (payload::Structure<T>) {
    const auto probe = std::make_unique<T>();
    const auto* base = reinterpret_cast<const std::byte*>(probe.get());
    payload::WithFields<T>([&](const auto&... field) {
      ((hash = Mix(hash, static_cast<std::uint64_t>(
                             reinterpret_cast<const std::byte*>(&field.Of(*probe)) - base)),
        hash = Of<payload::TypeOf<decltype(field)>>(hash)),
       ...);
    });
  } else if constexpr (payload::Array<T>) {
    hash = Of<payload::ElementOf<T>>(hash);
  } else if constexpr (payload::Sequence<T>) {
    hash = Of<payload::ItemOf<T>>(hash);
  }
  return hash;
}

}  // namespace layout

/// Returns the layout of a type. It is computed once per type, which allocates one T.
template <Payload T>
Layout LayoutOf() {
  static const Layout value = [] {
    constexpr std::uint64_t kSeed = 0xcbf29ce484222325;  // of FNV-1a
    const Layout seed = layout::Mix(layout::Mix(kSeed, kCxxAbi), kCxxLibraryAbi);
    return layout::Of<T>(seed) | 1U;  // never kNone
  }();
  return value;
}

}  // namespace tendon
