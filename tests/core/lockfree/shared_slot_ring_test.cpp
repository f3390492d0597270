#include <core/lockfree/ring_values.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/shared_slot_ring.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <thread>

namespace tendon {
namespace {

using test::Pop;
using test::Push;

TEST(SharedSlotRing, HoldsItsCapacityInOrderThroughManyWraps) {
  for (const std::size_t capacity : {1, 2, 3, 5, 64}) {
    SharedSlotRing<> ring(capacity, 8, 8);
    std::uint64_t pushed = 0;
    std::uint64_t popped = 0;
    for (std::uint64_t turn = 0; turn < 100; ++turn) {
      while (Push(ring, pushed)) ++pushed;
      ASSERT_EQ(pushed - popped, capacity);
      ASSERT_EQ(ring.size(), capacity);
      while (popped + turn % capacity < pushed) ASSERT_EQ(Pop(ring), popped++);
    }
  }
}

TEST(SharedSlotRing, OfZeroCapacityRefusesEverything) {
  SharedSlotRing<> ring(0, 8, 8);

  EXPECT_EQ(ring.Claim(), nullptr);
  EXPECT_EQ(ring.Front(), nullptr);
}

TEST(SharedSlotRing, TheReserveNeedsAnExplicitClaim) {
  SharedSlotRing<> ring(2, 8, 8, 1);
  while (Push(ring, 0)) {
  }

  std::byte* const reserved = ring.ClaimReserved();

  ASSERT_NE(reserved, nullptr);
  EXPECT_EQ(ring.ClaimReserved(), nullptr);
  EXPECT_EQ(ring.Claim(), nullptr);
  EXPECT_EQ(ring.size(), 3U);
}

TEST(SharedSlotRing, SlotsComeInTheOrderOfTheirClaims) {
  SharedSlotRing<> ring(4, 8, 8);
  std::byte* const first = ring.Claim();
  std::byte* const second = ring.Claim();
  EXPECT_NE(first, second);

  ring.Publish(second);
  EXPECT_EQ(ring.Front(), nullptr);
  ring.Publish(first);

  EXPECT_EQ(ring.Front(), first);
  ring.Release();
  EXPECT_EQ(ring.Front(), second);
}

TEST(SharedSlotRing, AllocatesNothingOnceMade) {
  SharedSlotRing<> ring(64, 64, 64);

  const AllocationGuard guard;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Push(ring, i);
    Pop(ring);
  }
}

TEST(SharedSlotRing, ManyProducersLoseTearAndReorderNothing) {
  using Message = std::array<std::uint64_t, 8>;
  constexpr std::uint64_t kProducers = 3;
  constexpr std::uint64_t kMessages = 10'000;
  SharedSlotRing<> ring(7, sizeof(Message), alignof(Message));
  std::array<std::jthread, kProducers> producers;
  for (std::uint64_t producer = 0; producer < kProducers; ++producer) {
    producers[producer] = std::jthread([&ring, producer] {
      for (std::uint64_t number = 0; number < kMessages;) {
        std::byte* const slot = ring.Claim();
        if (slot == nullptr) {
          std::this_thread::yield();
          continue;
        }
        Message message;
        message.fill(number++ * kProducers + producer);
        std::memcpy(slot, &message, sizeof(message));
        ring.Publish(slot);
      }
    });
  }

  std::uint64_t wrong = 0;
  std::array<std::uint64_t, kProducers> next{};
  for (std::uint64_t received = 0; received < kProducers * kMessages;) {
    const std::byte* const slot = ring.Front();
    if (slot == nullptr) {
      std::this_thread::yield();
      continue;
    }
    Message message;
    std::memcpy(&message, slot, sizeof(message));
    ring.Release();
    ++received;
    Message expected;
    const std::uint64_t producer = message[0] % kProducers;
    expected.fill(next[producer]++ * kProducers + producer);
    if (message != expected) ++wrong;
  }

  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(ring.Front(), nullptr);
}

}  // namespace
}  // namespace tendon
