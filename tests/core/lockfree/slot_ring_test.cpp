#include <core/lockfree/ring_values.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/slot_ring.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <set>
#include <thread>
#include <tuple>

namespace tendon {
namespace {

using test::kNothing;
using test::Pop;
using test::Push;

std::size_t Fill(SlotRing<>& ring) {
  std::size_t count = 0;
  while (Push(ring, count)) ++count;
  return count;
}

TEST(SlotRing, ACapacityOf64Holds64) {
  SlotRing<> ring(64, 8, 8);

  EXPECT_EQ(Fill(ring), 64U);
  EXPECT_EQ(ring.size(), 64U);
  EXPECT_EQ(ring.storage(), 64U);
}

TEST(SlotRing, HonoursACapacityThatIsNotAPowerOfTwo) {
  SlotRing<> ring(5, 8, 8);

  EXPECT_EQ(Fill(ring), 5U);
  EXPECT_EQ(ring.capacity(), 5U);
  EXPECT_EQ(ring.storage(), 8U);
}

TEST(SlotRing, OfZeroCapacityRefusesEverything) {
  SlotRing<> ring(0, 8, 8);

  EXPECT_EQ(ring.Claim(), nullptr);
  EXPECT_EQ(ring.Front(), nullptr);
}

TEST(SlotRing, KeepsTheOrderThroughManyWraps) {
  for (const std::size_t capacity : {1, 2, 3, 5, 8}) {
    SlotRing<> ring(capacity, 8, 8);
    std::uint64_t pushed = 0;
    std::uint64_t popped = 0;
    for (int turn = 0; turn < 100; ++turn) {
      while (Push(ring, pushed)) ++pushed;
      ASSERT_EQ(pushed - popped, capacity);
      const std::uint64_t leave = static_cast<std::uint64_t>(turn) % capacity;
      while (popped + leave < pushed) ASSERT_EQ(Pop(ring), popped++);
    }
  }
}

TEST(SlotRing, ARefusedClaimChangesNothing) {
  SlotRing<> ring(2, 8, 8);
  Fill(ring);

  EXPECT_EQ(ring.Claim(), nullptr);

  EXPECT_EQ(ring.size(), 2U);
  EXPECT_EQ(Pop(ring), 0U);
  EXPECT_EQ(Pop(ring), 1U);
  EXPECT_EQ(Pop(ring), kNothing);
}

TEST(SlotRing, AClaimedSlotIsInvisibleUntilItIsPublished) {
  SlotRing<> ring(2, 8, 8);

  std::byte* const claimed = ring.Claim();
  EXPECT_EQ(ring.Front(), nullptr);
  EXPECT_EQ(ring.Claim(), claimed);
  ring.Publish();

  EXPECT_EQ(ring.Front(), claimed);
}

TEST(SlotRing, AFrontSlotIsNotReusedUntilItIsReleased) {
  SlotRing<> ring(1, 8, 8);
  Push(ring, 7);

  const std::byte* const front = ring.Front();
  EXPECT_EQ(ring.Claim(), nullptr);
  EXPECT_EQ(ring.Front(), front);
  ring.Release();

  EXPECT_EQ(ring.Claim(), front);
}

TEST(SlotRing, TheReserveNeedsAnExplicitClaim) {
  SlotRing<> ring(2, 8, 8, 1);
  EXPECT_EQ(Fill(ring), 2U);

  ASSERT_NE(ring.ClaimReserved(), nullptr);
  ring.Publish();

  EXPECT_EQ(ring.ClaimReserved(), nullptr);
  EXPECT_EQ(ring.Claim(), nullptr);
  EXPECT_EQ(ring.size(), 3U);
}

TEST(SlotRing, CountsWaitingSlots) {
  SlotRing<> ring(4, 8, 8);
  EXPECT_EQ(ring.size(), 0U);
  Push(ring, 1);
  Push(ring, 2);
  EXPECT_EQ(ring.size(), 2U);
  Pop(ring);
  EXPECT_EQ(ring.size(), 1U);
  EXPECT_EQ(ring.released(), 1U);
}

/// Parameters: size, alignment, and the resulting stride.
class SlotRingShape
    : public testing::TestWithParam<std::tuple<std::size_t, std::size_t, std::size_t>> {};

TEST_P(SlotRingShape, SlotsAreAlignedAndNumbered) {
  const auto [size, alignment, stride] = GetParam();
  SlotRing<> ring(6, size, alignment);
  EXPECT_EQ(ring.stride(), stride);

  std::set<std::size_t> seen;
  for (std::size_t i = 0; i < 3 * ring.storage(); ++i) {
    std::byte* const slot = ring.Claim();
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(slot) % std::max<std::size_t>(alignment, 64), 0U);
    EXPECT_EQ(ring.IndexOf(slot), i % ring.storage());
    std::memset(slot, static_cast<int>(i), size);
    seen.insert(ring.IndexOf(slot));
    ring.Publish();
    ring.Release();
  }
  EXPECT_EQ(seen.size(), ring.storage());
}

INSTANTIATE_TEST_SUITE_P(, SlotRingShape,
                         testing::Values(std::tuple(1, 1, 64), std::tuple(64, 8, 64),
                                         std::tuple(65, 8, 128), std::tuple(100, 64, 128),
                                         std::tuple(192, 16, 192), std::tuple(448, 8, 448),
                                         std::tuple(40, 256, 256), std::tuple(5000, 128, 5120)));

TEST(SlotRing, AllocatesNothingOnceMade) {
  SlotRing<> ring(64, 64, 64);

  const AllocationGuard guard;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Push(ring, i);
    Pop(ring);
  }
}

TEST(SlotRing, TwoThreadsLoseTearAndReorderNothing) {
  using Message = std::array<std::uint64_t, 8>;
  constexpr std::uint64_t kMessages = 200'000;
  SlotRing<> ring(7, sizeof(Message), alignof(Message));

  std::thread producer([&] {
    for (std::uint64_t number = 0; number < kMessages;) {
      std::byte* const slot = ring.Claim();
      if (slot == nullptr) {
        std::this_thread::yield();
        continue;
      }
      Message message;
      message.fill(number++);
      std::memcpy(slot, &message, sizeof(message));
      ring.Publish();
    }
  });
  std::uint64_t wrong = 0;
  for (std::uint64_t number = 0; number < kMessages;) {
    const std::byte* const slot = ring.Front();
    if (slot == nullptr) {
      std::this_thread::yield();
      continue;
    }
    Message expected;
    expected.fill(number++);
    if (std::memcmp(slot, &expected, sizeof(expected)) != 0) ++wrong;
    ring.Release();
  }
  producer.join();

  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(ring.Front(), nullptr);
}

}  // namespace
}  // namespace tendon
