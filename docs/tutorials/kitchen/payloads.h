#pragma once

#include <tendon/payload/payload.h>

#include <cstdint>

namespace kitchen {

/// One thing to bake.
struct Recipe {
  double temperature = 180.0;  // degC
  double duration = 1.0;       // s at that temperature
};

/// What became of it.
struct Batch {
  std::uint64_t number = 0;
  double temperature = 0.0;  // degC
};

/// The configuration of an oven.
struct OvenConfiguration {
  double heating = 100.0;  // K/s
};

}  // namespace kitchen

template <>
inline constexpr auto tendon::kPayload<kitchen::Recipe> = tendon::Describe(
    "kitchen.Recipe",
    tendon::Field{"temperature", &kitchen::Recipe::temperature, "degC"}.Within(20, 300),
    tendon::Field{"duration", &kitchen::Recipe::duration, "s"}.Help("At that temperature."));

template <>
inline constexpr auto tendon::kPayload<kitchen::Batch> =
    tendon::Describe<kitchen::Batch>("kitchen.Batch", "number", "temperature in degC");

template <>
inline constexpr auto tendon::kPayload<kitchen::OvenConfiguration> = tendon::Describe(
    "kitchen.OvenConfiguration",
    tendon::Field{"heating", &kitchen::OvenConfiguration::heating, "K/s"}.Within(1, 1000));
