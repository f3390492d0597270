#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/triple_buffer.h>
#include <tendon/lockfree/try_lock.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <thread>

namespace tendon {
namespace {

TEST(TripleBuffer, ReturnsTheNewestValueOnce) {
  TripleBuffer<int> buffer;
  EXPECT_EQ(buffer.Take(), nullptr);

  EXPECT_FALSE(buffer.Write(1));
  EXPECT_TRUE(buffer.Write(2));
  EXPECT_TRUE(buffer.is_fresh());

  ASSERT_NE(buffer.Take(), nullptr);
  EXPECT_FALSE(buffer.is_fresh());
  EXPECT_EQ(buffer.Take(), nullptr);
  EXPECT_FALSE(buffer.Write(3));
  EXPECT_EQ(*buffer.Take(), 3);
}

TEST(TripleBuffer, KeepsTheMemoryOfItsValues) {
  const std::string text(100, 'x');
  TripleBuffer<std::string> buffer;
  for (int i = 0; i < 3; ++i) {
    buffer.Write(text);
    buffer.Take();
  }

  const AllocationGuard guard;
  for (int i = 0; i < 10; ++i) buffer.Write(text);
  ASSERT_NE(buffer.Take(), nullptr);
}

TEST(TripleBuffer, AFailedWriteKeepsTheWaitingValue) {
  TripleBuffer<int> buffer;
  buffer.WriteWith([](int& place) { place = 1; });

  EXPECT_THROW(buffer.WriteWith([](int& place) {
    place = 2;
    throw std::bad_alloc();
  }),
               std::bad_alloc);

  EXPECT_EQ(*buffer.Take(), 1);
  EXPECT_EQ(buffer.Take(), nullptr);
}

TEST(TripleBuffer, ATakenValueStaysIntactDuringWrites) {
  using Block = std::array<std::uint64_t, 32>;
  constexpr std::uint64_t kWrites = 200'000;
  const auto buffer = std::make_unique<TripleBuffer<Block>>();
  std::jthread writer([&] {
    Block block{};
    for (std::uint64_t n = 1; n <= kWrites; ++n) {
      block.fill(n);
      buffer->Write(block);
    }
  });

  std::uint64_t wrong = 0;
  for (std::uint64_t last = 0; last < kWrites;) {
    const Block* block = buffer->Take();
    if (block == nullptr) {
      std::this_thread::yield();
      continue;
    }
    Block expected;
    expected.fill((*block)[0]);
    if (*block != expected || (*block)[0] <= last) ++wrong;
    last = (*block)[0];
  }

  EXPECT_EQ(wrong, 0U);
}

TEST(TryLock, HasOneHolderAtATime) {
  TryLock<> lease;

  EXPECT_TRUE(lease.TryTake());
  EXPECT_FALSE(lease.TryTake());
  lease.Return();

  EXPECT_TRUE(lease.TryTake());
}

}  // namespace
}  // namespace tendon
