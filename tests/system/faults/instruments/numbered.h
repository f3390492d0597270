#pragma once

#include <tendon/payload/payload.h>

#include <cstdint>

namespace faults {

/// A command or a sample with a number. From the numbers alone, a receiver can detect missing,
/// repeated and damaged ones.
struct Numbered {
  std::uint64_t source = 0;  ///< a random number for one life of one component
  std::uint64_t number = 0;  ///< one more than in the previous command or sample
  std::uint64_t check = 0;   ///< CheckOf() the other two

  bool operator==(const Numbered&) const = default;
};

constexpr std::uint64_t CheckOf(std::uint64_t source, std::uint64_t number) {
  constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;
  const std::uint64_t mixed = (source ^ (number * kGolden)) * kGolden;
  return mixed ^ (mixed >> 29U);
}

constexpr Numbered MakeNumbered(std::uint64_t source, std::uint64_t number) {
  return {.source = source, .number = number, .check = CheckOf(source, number)};
}

constexpr bool IsWhole(const Numbered& one) { return one.check == CheckOf(one.source, one.number); }

}  // namespace faults

template <>
inline constexpr auto tendon::kPayload<faults::Numbered> =
    tendon::Describe("faults.Numbered", tendon::Field{"source", &faults::Numbered::source},
                     tendon::Field{"number", &faults::Numbered::number},
                     tendon::Field{"check", &faults::Numbered::check});
