#pragma once

#include <support/simulation/simulated_atomics.h>
#include <tendon/lockfree/slot_ring.h>

#include <array>
#include <cstddef>

namespace tendon::simulation {

/// For simulations: passes three messages through a ring of two slots. The content of the slots is
/// plain memory.
template <typename Atomics>
struct RingTransfer {
  SlotRing<Atomics> ring{2, 8, 8};
  std::array<Plain<int>, 2> slots;

  void Produce() {
    for (int message = 1; message <= kMessages; ++message) {
      std::byte* slot = nullptr;
      for (unsigned looks = 0; (slot = ring.Claim()) == nullptr; ++looks) Atomics::Pause(looks);
      slots[ring.IndexOf(slot)].Write(message);
      ring.Publish();
    }
  }
  void Consume() {
    for (int message = 1; message <= kMessages; ++message) {
      std::byte* slot = nullptr;
      for (unsigned looks = 0; (slot = ring.Front()) == nullptr; ++looks) Atomics::Pause(looks);
      Check(slots[ring.IndexOf(slot)].Read() == message, "a message is lost");
      ring.Release();
    }
  }

  static constexpr int kMessages = 3;
};

}  // namespace tendon::simulation
