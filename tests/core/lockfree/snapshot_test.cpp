#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <tendon/lockfree/snapshot.h>
#include <tendon/lockfree/try_lock.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

namespace tendon {
namespace {

TEST(Snapshot, GivesTheNewestValueOnce) {
  Snapshot<int> snapshot;
  EXPECT_EQ(snapshot.Take(), nullptr);

  EXPECT_FALSE(snapshot.Write(1));
  EXPECT_TRUE(snapshot.Write(2));
  EXPECT_TRUE(snapshot.is_fresh());

  ASSERT_NE(snapshot.Take(), nullptr);
  EXPECT_FALSE(snapshot.is_fresh());
  EXPECT_EQ(snapshot.Take(), nullptr);
  EXPECT_FALSE(snapshot.Write(3));
  EXPECT_EQ(*snapshot.Take(), 3);
}

TEST(Snapshot, KeepsWhatItsValuesHaveAllocated) {
  const std::string text(100, 'x');
  Snapshot<std::string> snapshot;
  for (int i = 0; i < 3; ++i) {
    snapshot.Write(text);
    snapshot.Take();
  }

  const AllocationGuard guard;
  for (int i = 0; i < 10; ++i) snapshot.Write(text);
  ASSERT_NE(snapshot.Take(), nullptr);
}

TEST(Snapshot, ATakenValueStaysWholeWhileNewerOnesAreWritten) {
  using Block = std::array<std::uint64_t, 32>;
  constexpr std::uint64_t kWrites = 200'000;
  const auto snapshot = std::make_unique<Snapshot<Block>>();
  std::jthread writer([&] {
    Block block{};
    for (std::uint64_t n = 1; n <= kWrites; ++n) {
      block.fill(n);
      snapshot->Write(block);
    }
  });

  std::uint64_t wrong = 0;
  for (std::uint64_t last = 0; last < kWrites;) {
    const Block* block = snapshot->Take();
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

TEST(TryLock, OneHasItAtATime) {
  TryLock<> lease;

  EXPECT_TRUE(lease.TryTake());
  EXPECT_FALSE(lease.TryTake());
  lease.Return();

  EXPECT_TRUE(lease.TryTake());
}

}  // namespace
}  // namespace tendon
