#include <gtest/gtest.h>
#include <tendon/proxy/mirrored_read.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

namespace tendon {
namespace {

using Value = std::vector<std::byte>;

SteadyTime At(std::int64_t time) { return SteadyTime(std::chrono::nanoseconds(time)); }

TEST(MirroredValue, ReturnsTheLastValueAndItsTime) {
  MirroredValue mirrored(9);
  Value value;
  SteadyTime time;
  EXPECT_EQ(mirrored.Read(value, time), Status(Status::kNoSample));

  EXPECT_TRUE(mirrored.Put(At(1), Value(9, std::byte{1})));
  EXPECT_TRUE(mirrored.Put(At(2), Value(3, std::byte{2})));

  EXPECT_EQ(mirrored.Read(value, time), Status(Status::kDone));
  EXPECT_EQ(value, Value(3, std::byte{2}));
  EXPECT_EQ(time, At(2));
}

TEST(MirroredValue, RefusesAValueLargerThanDeclared) {
  MirroredValue mirrored(9);
  Value value;
  SteadyTime time;
  EXPECT_TRUE(mirrored.Put(At(1), Value(9, std::byte{1})));

  EXPECT_FALSE(mirrored.Put(At(2), Value(10, std::byte{2})));

  EXPECT_EQ(mirrored.Read(value, time), Status(Status::kDone));
  EXPECT_EQ(value, Value(9, std::byte{1}));
}

TEST(MirroredValue, ReturnsNothingWithoutAValueAndAfterItsEnd) {
  MirroredValue mirrored(9);
  Value value;
  SteadyTime time;
  EXPECT_TRUE(mirrored.Put(At(1), Value(9, std::byte{1})));
  EXPECT_TRUE(mirrored.Put(At(2), {}));
  EXPECT_EQ(mirrored.Read(value, time), Status(Status::kNoSample));

  EXPECT_TRUE(mirrored.Put(At(3), Value(9, std::byte{1})));
  mirrored.End();

  EXPECT_EQ(mirrored.Read(value, time), Status(Status::kNotConnected));
}

TEST(MirroredValue, ReadersSeeIntactValuesDuringWrites) {
  constexpr std::int64_t kCopies = 20'000;
  MirroredValue mirrored(255);
  const auto read = [&mirrored] {
    Value value;
    SteadyTime time{};
    while (time != At(kCopies)) {
      if (!mirrored.Read(value, time)) continue;
      const auto number = static_cast<std::size_t>(time.time_since_epoch().count());
      ASSERT_EQ(value.size(), 1 + number % 255);
      ASSERT_TRUE(std::ranges::all_of(
          value, [&](std::byte one) { return one == static_cast<std::byte>(number); }));
    }
  };
  std::thread first(read);
  std::thread second(read);

  for (std::int64_t copy = 1; copy <= kCopies; ++copy) {
    const auto size = static_cast<std::size_t>(1 + copy % 255);
    (void)mirrored.Put(At(copy), Value(size, static_cast<std::byte>(copy)));
  }

  first.join();
  second.join();
}

}  // namespace
}  // namespace tendon
