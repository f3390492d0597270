#include <gtest/gtest.h>
#include <tendon/base/status.h>
#include <tendon/middleware/part_receiver.h>
#include <tendon/middleware/part_sender.h>

#include <chrono>
#include <cstdint>

namespace tendon {
namespace {

using namespace std::chrono_literals;

class PartReceiverTest : public testing::Test {
 protected:
  /// Returns a frame of three parts.
  static Bytes LargeFrame() {
    FrameHeader header;
    header.type = static_cast<MessageType>(0x100);
    header.size = static_cast<std::uint32_t>(2 * kPartSize);
    Bytes frame;
    WriteFrame(header, Bytes(header.size), frame);
    return frame;
  }
  void AddFirstPart() {
    const Bytes frame = LargeFrame();
    PartAssembly::Frame whole;
    ASSERT_EQ(receiver_.Add(1, std::span(frame).first(kPartSize), whole),
              PartAssembly::Progress::kMoreToCome);
  }

  PartReceiver receiver_{nullptr};
};

TEST_F(PartReceiverTest, ReportsArrivedBytesOnce) {
  EXPECT_FALSE(receiver_.has_news());
  AddFirstPart();
  EXPECT_TRUE(receiver_.has_news());

  std::uint64_t reported = 0;
  receiver_.Report([&](std::uint64_t taken) -> Status {
    reported = taken;
    return Status::kQueued;
  });

  EXPECT_EQ(reported, kPartSize);
  EXPECT_FALSE(receiver_.has_news());
}

TEST_F(PartReceiverTest, AFailedReportStaysDue) {
  AddFirstPart();

  receiver_.Report([](std::uint64_t /*taken*/) -> Status { return Status::kQueueFull; });

  EXPECT_TRUE(receiver_.has_news());
}

TEST_F(PartReceiverTest, AnUnfinishedMessageTimesOutUntilItIsCleared) {
  const SteadyTime later = SteadyClock().Now() + PartAssembly::kPartTimeout + 60s;
  EXPECT_FALSE(receiver_.IsUnfinishedTooLong(later));

  AddFirstPart();
  EXPECT_FALSE(receiver_.IsUnfinishedTooLong(SteadyClock().Now()));
  EXPECT_TRUE(receiver_.IsUnfinishedTooLong(later));

  receiver_.Clear();
  EXPECT_FALSE(receiver_.IsUnfinishedTooLong(later));
}

}  // namespace
}  // namespace tendon
