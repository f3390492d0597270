#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>

#include <array>
#include <atomic>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace tendon {
namespace {

struct alignas(256) Wide {
  std::array<char, 256> bytes;
};

TEST(AllocationGuard, FailsATestThatAllocates) {
  EXPECT_NONFATAL_FAILURE(
      {
        const AllocationGuard guard;
        const std::vector<int> numbers(3);
        ASSERT_EQ(numbers.size(), 3U);
      },
      "allocations in this thread");
}

TEST(AllocationGuard, CountsArraysAndOverAlignedObjects) {
  EXPECT_NONFATAL_FAILURE(
      {
        const AllocationGuard guard;
        const auto array = std::make_unique<char[]>(10);
        const auto wide = std::make_unique<Wide>();
        ASSERT_EQ(guard.allocations(), 2U);
      },
      "allocations in this thread");
}

TEST(AllocationGuard, CountsNothrowAllocations) {
  EXPECT_NONFATAL_FAILURE(
      {
        const AllocationGuard guard;
        const std::unique_ptr<char[]> array(new (std::nothrow) char[10]);
        const std::unique_ptr<Wide> wide(new (std::nothrow) Wide);
        ASSERT_EQ(guard.allocations(), 2U);
      },
      "allocations in this thread");
}

TEST(AllocationGuard, IgnoresOtherThreads) {
  std::atomic<bool> may_allocate = false;
  std::atomic<bool> has_allocated = false;
  std::vector<int> numbers;
  std::thread other([&] {
    while (!may_allocate) std::this_thread::yield();
    numbers.resize(100);
    has_allocated = true;
  });

  {
    const AllocationGuard guard;
    may_allocate = true;
    while (!has_allocated) std::this_thread::yield();
  }

  other.join();
}

}  // namespace
}  // namespace tendon
