#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

/// Finds the fields of an aggregate by their positions.
namespace tendon::payload {

/// The most fields that MemberAt() can find.
constexpr std::size_t kMaxFields = 24;

/// Converts to the type of any field. Only for unevaluated operands.
struct AnyValue {
  template <typename T>
  operator T() const;  // NOLINT(google-explicit-constructor)
};

template <typename T, typename Indices>
struct HasAtLeast;
template <typename T, std::size_t... kIndices>
struct HasAtLeast<T, std::index_sequence<kIndices...>> {
  template <std::size_t>
  using Any = AnyValue;
  static constexpr bool kValue = requires { T{Any<kIndices>{}...}; };
};
/// True if T has kCount or more fields. Each element of a C array counts as a field.
template <typename T, std::size_t kCount>
inline constexpr bool kHasAtLeast = HasAtLeast<T, std::make_index_sequence<kCount>>::kValue;

template <std::size_t kIndex, typename First, typename... Rest>
constexpr auto& Nth([[maybe_unused]] First& first, [[maybe_unused]] Rest&... rest) {
  if constexpr (kIndex == 0) {
    return first;
  } else {
    return Nth<kIndex - 1>(rest...);
  }
}

/// MemberAt() for aggregates with more than 12 fields.
template <std::size_t kIndex, std::size_t kCount, typename T>
constexpr auto& MemberOfLarge(T& value) {
  if constexpr (kCount == 13) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m);
  } else if constexpr (kCount == 14) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
  } else if constexpr (kCount == 15) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o);
  } else if constexpr (kCount == 16) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p);
  } else if constexpr (kCount == 17) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q);
  } else if constexpr (kCount == 18) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r);
  } else if constexpr (kCount == 19) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s);
  } else if constexpr (kCount == 20) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t);
  } else if constexpr (kCount == 21) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u);
  } else if constexpr (kCount == 22) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v);
  } else if constexpr (kCount == 23) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w);
  } else if constexpr (kCount == 24) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x);
  }
}

/// Returns a field of an aggregate that has kCount fields and no base class.
template <std::size_t kIndex, std::size_t kCount, typename T>
constexpr auto& MemberAt(T& value) {
  if constexpr (kCount == 1) {
    auto& [a] = value;
    return Nth<kIndex>(a);
  } else if constexpr (kCount == 2) {
    auto& [a, b] = value;
    return Nth<kIndex>(a, b);
  } else if constexpr (kCount == 3) {
    auto& [a, b, c] = value;
    return Nth<kIndex>(a, b, c);
  } else if constexpr (kCount == 4) {
    auto& [a, b, c, d] = value;
    return Nth<kIndex>(a, b, c, d);
  } else if constexpr (kCount == 5) {
    auto& [a, b, c, d, e] = value;
    return Nth<kIndex>(a, b, c, d, e);
  } else if constexpr (kCount == 6) {
    auto& [a, b, c, d, e, f] = value;
    return Nth<kIndex>(a, b, c, d, e, f);
  } else if constexpr (kCount == 7) {
    auto& [a, b, c, d, e, f, g] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g);
  } else if constexpr (kCount == 8) {
    auto& [a, b, c, d, e, f, g, h] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h);
  } else if constexpr (kCount == 9) {
    auto& [a, b, c, d, e, f, g, h, i] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i);
  } else if constexpr (kCount == 10) {
    auto& [a, b, c, d, e, f, g, h, i, j] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j);
  } else if constexpr (kCount == 11) {
    auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k);
  } else if constexpr (kCount == 12) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
    return Nth<kIndex>(a, b, c, d, e, f, g, h, i, j, k, l);
  } else {
    return MemberOfLarge<kIndex, kCount>(value);
  }
}

}  // namespace tendon::payload
