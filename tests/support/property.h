#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

/// Checks properties of all numbers with RapidCheck.
namespace tendon::test {

/// Returns doubles that often break arithmetic: limits, denormals, and values that differ only in
/// the last digits.
inline std::vector<double> EdgeDoubles() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> edges = {0.0,
                               Limits::min(),
                               Limits::denorm_min(),
                               1.0,
                               1.0 + Limits::epsilon(),
                               1.000000000001,
                               5e-14,
                               1e-12,
                               0.1,
                               9e9,
                               1764300000.25,
                               1e15,
                               0x1p53,
                               0x1p53 + 2,
                               0x1p63,
                               0x1p64,
                               1e100,
                               Limits::max() / 2,
                               1e308,
                               Limits::max(),
                               0x1p-1022 - 0x1p-1074,
                               1.0 / 3,
                               Limits::infinity(),
                               Limits::quiet_NaN()};
  const std::size_t count = edges.size();
  for (std::size_t i = 0; i < count; ++i) edges.push_back(-edges[i]);
  return edges;
}

/// Generates edge cases, their neighbours, any 64 bits, and RapidCheck's own small doubles.
inline rc::Gen<double> AnyDouble() {
  const auto edges = rc::gen::elementOf(EdgeDoubles());
  const auto infinity = std::numeric_limits<double>::infinity();
  return rc::gen::oneOf(
      edges, rc::gen::map(edges, [=](double edge) { return std::nextafter(edge, infinity); }),
      rc::gen::map(rc::gen::resize(1000, rc::gen::arbitrary<std::uint64_t>()),
                   [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
      rc::gen::arbitrary<double>());
}

inline rc::Gen<double> AnyFinite() {
  return rc::gen::suchThat(AnyDouble(), [](double value) { return std::isfinite(value); });
}

/// Generates limits, integers near the largest that a double represents exactly, and any other
/// integers.
template <std::integral Integer>
rc::Gen<Integer> AnyInteger() {
  using Limits = std::numeric_limits<Integer>;
  std::vector<Integer> edges = {Limits::min(), Limits::max(), 0, 1, Limits::max() - 1};
  if constexpr (sizeof(Integer) == 8) {
    for (const std::int64_t off : {-1, 0, 1}) {
      edges.push_back(static_cast<Integer>((std::int64_t{1} << 53) + off));
      edges.push_back(static_cast<Integer>(1'764'300'000'000'000'000 + off));
    }
  }
  return rc::gen::oneOf(rc::gen::elementOf(edges),
                        rc::gen::resize(1000, rc::gen::arbitrary<Integer>()),
                        rc::gen::arbitrary<Integer>());
}

/// Checks a property, whose body uses RC_ASSERT(), for a few hundred cases. If TENDON_FULL_FAULTS
/// is set, checks it for a minute. To repeat a failure, set RC_PARAMS as printed by RapidCheck.
template <typename Property>
void CheckProperty(Property property) {
  constexpr std::chrono::minutes kFull(1);
  constexpr int kCases = 300;
  const bool is_full = std::getenv("TENDON_FULL_FAULTS") != nullptr;
  const auto end = std::chrono::steady_clock::now() + kFull;
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = kCases;
  do {
    const auto result = rc::detail::checkTestable(property, rc::detail::TestMetadata{}, params);
    std::ostringstream words;
    rc::detail::printResultMessage(result, words);
    ASSERT_TRUE(result.template is<rc::detail::SuccessResult>())
        << words.str() << "\nseed " << params.seed;
    ++params.seed;
  } while (is_full && std::chrono::steady_clock::now() < end);
}

}  // namespace tendon::test
