#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tendon::test {

/// The result of Pop() if the ring is empty.
inline constexpr std::uint64_t kNothing = ~std::uint64_t{0};

/// Puts a number into a ring of slots; false when it is full.
template <typename Ring>
bool Push(Ring& ring, std::uint64_t value) {
  std::byte* const slot = ring.Claim();
  if (slot == nullptr) return false;
  std::memcpy(slot, &value, sizeof(value));
  if constexpr (requires { ring.Publish(slot); }) {
    ring.Publish(slot);
  } else {
    ring.Publish();
  }
  return true;
}

/// The oldest number in a ring.
template <typename Ring>
std::uint64_t Pop(Ring& ring) {
  const std::byte* const slot = ring.Front();
  if (slot == nullptr) return kNothing;
  std::uint64_t value = 0;
  std::memcpy(&value, slot, sizeof(value));
  ring.Release();
  return value;
}

}  // namespace tendon::test
