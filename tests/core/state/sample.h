#pragma once

#include <tendon/base/clock.h>
#include <tendon/payload/payload.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tendon::test {

/// A fixed payload with padding in its encoded form.
struct Sample {
  std::array<double, 3> position{};
  std::uint8_t mode = 0;
  std::int32_t count = 0;

  bool operator==(const Sample&) const = default;
};

/// A dynamic payload.
struct Report {
  std::string text;
  std::vector<double> values;

  bool operator==(const Report&) const = default;
};

enum class Gear : std::int32_t { kLow = 1, kHigh = 2 };

/// Returns times with a distance of 50 ns, so that times differ from ticks.
constexpr SteadyTime TimeOf(std::uint64_t tick) {
  return SteadyTime(std::chrono::nanoseconds(1'000'000 + 50 * static_cast<std::int64_t>(tick)));
}

}  // namespace tendon::test

template <>
inline constexpr auto tendon::kPayload<tendon::test::Sample> =
    tendon::Describe("test.Sample", tendon::Field{"position", &tendon::test::Sample::position, "m"},
                     tendon::Field{"mode", &tendon::test::Sample::mode},
                     tendon::Field{"count", &tendon::test::Sample::count});

template <>
inline constexpr auto tendon::kPayload<tendon::test::Report> =
    tendon::Describe("test.Report", tendon::Field{"text", &tendon::test::Report::text},
                     tendon::Field{"values", &tendon::test::Report::values});

template <>
inline constexpr auto tendon::kPayload<tendon::test::Gear> =
    tendon::DescribeEnum("test.Gear", tendon::Enumerator{"low", tendon::test::Gear::kLow},
                         tendon::Enumerator{"high", tendon::test::Gear::kHigh});
