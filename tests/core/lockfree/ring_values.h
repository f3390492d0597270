#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tendon::test {

/// The result of the pop function below if the ring is empty.
inline constexpr std::uint64_t kNothing = ~std::uint64_t{0};

/// Puts a number into a ring of slots. Returns false if the ring is full.
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

/// Removes and returns the oldest number in a ring; kNothing if the ring is empty.
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
