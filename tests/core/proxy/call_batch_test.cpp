#include <gtest/gtest.h>
#include <tendon/proxy/call_batch.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace {

using tendon::Bytes;
using tendon::CallBatch;
using tendon::CallBuffer;
using tendon::FrameHeader;
using Calls = std::vector<std::pair<std::uint32_t, Bytes>>;

Bytes Filled(std::size_t size, int value) { return Bytes(size, static_cast<std::byte>(value)); }

Calls Read(std::span<const std::byte> body) {
  Calls calls;
  tendon::ForEachCall(body, [&](std::uint32_t handle, std::span<const std::byte> argument) {
    calls.emplace_back(handle, Bytes(argument.begin(), argument.end()));
  });
  return calls;
}

TEST(CallBatch, ReadsBackWhatWasWritten) {
  const Calls calls{{7, Filled(3, 1)}, {8, {}}, {0xffffffffU, Filled(16, 2)}, {9, Filled(1, 3)}};
  CallBatch batch;
  for (int round = 0; round < 2; ++round) {
    EXPECT_TRUE(batch.empty());
    for (const auto& [handle, argument] : calls) batch.Add(handle, argument);

    EXPECT_EQ(batch.calls(), calls.size());
    EXPECT_EQ(Read(batch.body()), calls);
    batch.Clear();
  }
}

TEST(CallBatch, ReadsBackTimesAsWritten) {
  struct TimedCall {
    std::uint32_t handle;
    Bytes argument;
    tendon::SteadyTime time;
    bool operator==(const TimedCall&) const = default;
  };
  const std::vector<TimedCall> calls{
      {7, Filled(3, 1), tendon::SteadyTime(std::chrono::nanoseconds(5))},
      {8, {}, tendon::SteadyTime(std::chrono::nanoseconds(-6))}};
  CallBatch batch;
  for (const TimedCall& call : calls) batch.AddTimed(call.handle, call.argument, call.time);
  batch.Add(9, Filled(7, 1));  // too short for a time

  std::vector<TimedCall> read;
  tendon::ForEachTimedCall(
      batch.body(),
      [&](std::uint32_t handle, std::span<const std::byte> argument, tendon::SteadyTime time) {
        read.push_back({handle, Bytes(argument.begin(), argument.end()), time});
      });

  EXPECT_EQ(batch.calls(), 3U);
  EXPECT_EQ(read, calls);
}

TEST(CallBatch, ReservesRoomForTheFrameHeader) {
  CallBatch batch;
  EXPECT_TRUE(batch.frame().empty());
  EXPECT_TRUE(batch.body().empty());
  for (int round = 0; round < 2; ++round) {
    batch.Add(1, Filled(8, round));
    batch.Add(2, Filled(8, round));

    EXPECT_EQ(batch.body().size(), 32U);
    EXPECT_EQ(batch.frame().size(), FrameHeader::kSize + 32U);
    EXPECT_EQ(batch.body().data(), batch.frame().data() + FrameHeader::kSize);
    batch.Clear();
  }
}

tendon::Bytes Copy(std::span<const std::byte> bytes) { return {bytes.begin(), bytes.end()}; }

TEST(CallBuffer, IsLaidOutLikeABatchWithOneCall) {
  const tendon::SteadyTime time(std::chrono::nanoseconds(5));
  CallBuffer call;
  for (const std::size_t size : {30, 0, 1, 7, 8, 9, 100}) {
    const Bytes argument = Filled(size, 1);
    CallBatch batch;
    batch.Add(7, argument);
    CallBatch timed;
    timed.AddTimed(7, argument, time);

    std::ranges::copy(argument, call.Resize(size).begin());

    for (int round = 0; round < 2; ++round) {
      const auto frame = call.Frame(7);
      ASSERT_EQ(frame.size(), batch.frame().size()) << size;
      EXPECT_EQ(Copy(frame.subspan(FrameHeader::kSize)), Copy(batch.body())) << size;
      EXPECT_EQ(Copy(call.TimedFrame(7, time).subspan(FrameHeader::kSize)), Copy(timed.body()))
          << size;
      EXPECT_EQ(Copy(call.argument()), argument) << size;
    }
  }
}

TEST(CallBuffer, KeepsItsMemory) {
  CallBuffer call;
  const std::byte* const place = call.Resize(100).data();
  const std::size_t capacity = call.capacity();

  for (const std::size_t size : {0, 100, 50}) {
    EXPECT_EQ(call.Resize(size).data(), place);
    EXPECT_EQ(call.capacity(), capacity);
    EXPECT_EQ(call.Frame(1).data() + FrameHeader::kSize + 8, place) << "the argument is not copied";
  }
}

TEST(CallBatch, TruncatedBatchYieldsItsCompleteCalls) {
  CallBatch batch;
  batch.Add(1, Filled(8, 1));
  batch.Add(2, Filled(8, 2));

  EXPECT_EQ(Read(std::span(batch.body()).first(31)).size(), 1U);
  EXPECT_EQ(Read(std::span(batch.body()).first(15)).size(), 0U);
  EXPECT_EQ(Read({}).size(), 0U);
}

TEST(CallBatch, ReadsRandomBytesWithinItsBounds) {
  std::mt19937 random(1);
  for (int round = 0; round < 20'000; ++round) {
    Bytes body(random() % 64);
    for (std::byte& byte : body) byte = static_cast<std::byte>(random() % 4);
    tendon::ForEachCall(body, [&](std::uint32_t /*handle*/, std::span<const std::byte> argument) {
      ASSERT_GE(argument.data(), body.data());
      ASSERT_LE(argument.data() + argument.size(), body.data() + body.size());
    });
  }
}

}  // namespace
