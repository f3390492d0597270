#pragma once

#include <tendon/payload/payload.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <type_traits>

namespace sample {

/// Fills a payload of any type with random values. The values are the same in every run.
template <typename T>
void Randomise(std::mt19937& random, T& value) {
  namespace payload = tendon::payload;
  if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(std::normal_distribution<double>(0, 1e3)(random));
  } else if constexpr (std::same_as<T, bool>) {
    value = random() % 2 == 1;
  } else if constexpr (payload::Number<T>) {
    value = static_cast<T>((std::uint64_t{random()} << 32) | random());
  } else if constexpr (payload::NamedEnum<T>) {
    const auto& enumerators = tendon::kPayload<T>.enumerators;
    value = enumerators[random() % enumerators.size()].value;
  } else if constexpr (payload::Enum<T>) {
    value = static_cast<T>(random() % 256);
  } else if constexpr (payload::Text<T>) {
    value.assign(random() % 9, static_cast<char>('a' + random() % 26));
  } else if constexpr (payload::TimeSpan<T>) {
    value = T(static_cast<typename T::rep>(random()) - (1U << 31));
  } else if constexpr (requires { value.time_since_epoch(); }) {
    typename T::duration since_epoch{};
    Randomise(random, since_epoch);
    value = T(since_epoch);
  } else if constexpr (payload::Array<T>) {
    for (auto& element : value) Randomise(random, element);
  } else if constexpr (std::same_as<T, std::vector<bool>>) {
    value.resize(random() % 5);
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = random() % 2 == 1;
  } else if constexpr (payload::Sequence<T>) {
    value.resize(random() % 5);
    for (auto& element : value) Randomise(random, element);
  } else {
    payload::WithFields<T>(
        [&](const auto&... field) { (Randomise(random, value.*field.member), ...); });
  }
}

}  // namespace sample
