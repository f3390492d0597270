#include <gmock/gmock.h>
#include <tendon/middleware/part_assembly.h>
#include <tendon/middleware/part_sender.h>
#include <tendon/middleware/payload_limit.h>

#include <vector>

namespace tendon {
namespace {

using testing::ElementsAre;

/// Stores the sent frames while it has room.
class FakeLink final : public Link {
 public:
  Status Send(std::span<const std::byte> frame, Delivery /*delivery*/) override {
    if (!has_room) return Status::kQueueFull;
    const auto header = ReadWholeFrame(frame);
    EXPECT_TRUE(header && header->type == MessageType::kPart && frame.size() <= kMaxPieceSize);
    sent.push_back(header->handle);
    sizes.push_back(header->size);
    bytes += header->size;
    return Status::kQueued;
  }
  void Admit() override {}
  void Close() override {}
  [[nodiscard]] std::string peer() const override { return "peer"; }
  [[nodiscard]] std::string local() const override { return "local"; }

  bool has_room = true;
  std::vector<std::uint32_t> sent;  // for each part, the frame to which it belongs
  std::vector<std::size_t> sizes;   // sizes of the parts
  std::uint64_t bytes = 0;
};

// Number of parts; the headers of the parts count, too.
constexpr std::size_t kAhead = PartSender::kPartsAhead + 1;
constexpr std::chrono::nanoseconds kPartTime = PartSender::kPartTime;

/// A sender on a line that was measured as fast.
class PartSenderTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(Add(9, 1), Status::kQueued);
    while (sender.waiting() > 0) ASSERT_TRUE(sender.OnTaken(link, link.bytes));
    ASSERT_EQ(sender.part_size(), kPartSize);
    Forget();
  }
  void Forget() {
    begun = link.bytes;
    link.sent.clear();
    link.sizes.clear();
  }
  /// Reports that the peer has taken this number of bytes since `begun`.
  bool Take(std::uint64_t bytes) { return sender.OnTaken(link, begun + bytes); }
  /// Lets the peer take everything slowly, until a frame of this size has arrived.
  void TakeSlowly(std::size_t size, std::size_t bytes_in_part_time) {
    FrameHeader header;
    header.size = static_cast<std::uint32_t>(size - FrameHeader::kSize);
    ASSERT_EQ(sender.Add(link, 1, header, Bytes(header.size)), Status::kQueued);
    for (std::size_t part = 0; part < link.sizes.size(); ++part) {
      clock.Advance(link.sizes[part] * kPartTime / bytes_in_part_time);
      taken += link.sizes[part];
      ASSERT_TRUE(Take(taken));
    }
  }

  /// Adds a frame of this number of parts.
  Status Add(Lane lane, std::size_t parts) {
    FrameHeader header;
    header.type = static_cast<MessageType>(0x100);
    const Bytes body(parts * kPartSize - FrameHeader::kSize);
    header.size = static_cast<std::uint32_t>(body.size());
    return sender.Add(link, lane, header, body);
  }

  ManualClock clock;
  PartSender sender{clock};
  FakeLink link;
  std::uint64_t begun = 0;  // number of bytes that had been sent before the test
  std::uint64_t taken = 0;
};

TEST_F(PartSenderTest, TakesLargeMessagesAndThoseBehindThem) {
  EXPECT_FALSE(sender.MustSendInParts(1, kMaxPieceSize));
  EXPECT_TRUE(sender.MustSendInParts(1, kMaxPieceSize + 1));

  ASSERT_EQ(Add(1, 2 * kAhead), Status::kQueued);

  EXPECT_TRUE(sender.MustSendInParts(1, 30));
  EXPECT_FALSE(sender.MustSendInParts(2, 30));
  EXPECT_FALSE(sender.MustSendInParts(kCommonLane, 30));
  EXPECT_FALSE(sender.MustSendInParts(kOwnLane, 30));
}

TEST_F(PartSenderTest, LimitsUnacknowledgedParts) {
  ASSERT_EQ(Add(1, 3 * kAhead), Status::kQueued);
  EXPECT_EQ(link.sent.size(), kAhead);

  EXPECT_TRUE(Take(kPartSize));
  EXPECT_EQ(link.sent.size(), kAhead + 1);

  EXPECT_TRUE(Take((kAhead + 1) * kPartSize));
  EXPECT_EQ(link.sent.size(), 2 * kAhead + 1);
}

TEST_F(PartSenderTest, AlternatesBetweenLanesInOrder) {
  link.has_room = false;
  ASSERT_EQ(Add(1, 3), Status::kQueued);
  ASSERT_EQ(Add(2, 1), Status::kQueued);
  ASSERT_EQ(Add(2, 1), Status::kQueued);
  link.has_room = true;

  sender.Resume(link);

  EXPECT_THAT(link.sent, ElementsAre(2, 3, 2, 4, 2));
  EXPECT_FALSE(sender.MustSendInParts(1, 30));
}

TEST_F(PartSenderTest, ResumesWhenTheLinkHasRoom) {
  link.has_room = false;
  ASSERT_EQ(Add(1, 2), Status::kQueued);
  sender.Resume(link);
  EXPECT_TRUE(link.sent.empty());

  link.has_room = true;
  sender.Resume(link);

  EXPECT_THAT(link.sent, ElementsAre(2, 2));
}

TEST_F(PartSenderTest, StartsWithSmallParts) {
  PartSender unknown(clock);
  FakeLink fresh;
  EXPECT_EQ(unknown.part_size(), kMinPartSize);

  FrameHeader header;
  header.size = kMaxPieceSize;
  ASSERT_EQ(unknown.Add(fresh, 1, header, Bytes(kMaxPieceSize)), Status::kQueued);

  EXPECT_THAT(fresh.sizes, testing::Each(kMinPartSize));
  EXPECT_EQ(fresh.sizes.size(), kAhead);
}

TEST_F(PartSenderTest, SlowLinksGetSmallParts) {
  constexpr std::size_t kCarried = 100'000;  // bytes that the line carries in the time of a part
  TakeSlowly(std::size_t{8} << 20U, kCarried);
  EXPECT_LE(sender.part_size(), kCarried);
  EXPECT_GE(sender.part_size(), kCarried / 4);
  EXPECT_TRUE(sender.MustSendInParts(2, kCarried + FrameHeader::kSize + 1));

  Forget();
  taken = 0;
  TakeSlowly(std::size_t{1} << 20U, kCarried);

  EXPECT_THAT(link.sizes, testing::Each(testing::Le(kCarried)));
}

TEST_F(PartSenderTest, PartsGrowAgainOnAFasterLink) {
  TakeSlowly(std::size_t{4} << 20U, 1'000);
  EXPECT_EQ(sender.part_size(), kMinPartSize);

  Forget();
  taken = 0;
  TakeSlowly(std::size_t{4} << 20U, 100 * kPartSize);

  EXPECT_EQ(sender.part_size(), kPartSize);
}

TEST_F(PartSenderTest, AFastLinkCountsAsQuickForAWhile) {
  EXPECT_TRUE(sender.is_quick());

  clock.Advance(PartSender::kQuickFor);

  EXPECT_FALSE(sender.is_quick());
}

TEST_F(PartSenderTest, LargePartsDoNotMakeALinkQuick) {
  TakeSlowly(std::size_t{4} << 20U, kMaxReturned / 2);

  EXPECT_EQ(sender.part_size(), kPartSize);
  EXPECT_FALSE(sender.is_quick());
}

TEST_F(PartSenderTest, CountsAFrameUntilItIsAcknowledged) {
  ASSERT_EQ(Add(1, 2), Status::kQueued);
  EXPECT_EQ(sender.waiting(), 2 * kPartSize);

  EXPECT_TRUE(Take(kPartSize));
  EXPECT_EQ(sender.waiting(), 2 * kPartSize);
  EXPECT_TRUE(Take(2 * kPartSize));
  EXPECT_EQ(sender.waiting(), 0U);
}

TEST_F(PartSenderTest, RefusesFramesBeyondTheWindow) {
  constexpr std::size_t kHalf = kSendWindow / kPartSize / 2;
  EXPECT_EQ(Add(1, kHalf), Status::kQueued);
  EXPECT_EQ(Add(1, kHalf), Status::kQueued);
  EXPECT_EQ(Add(2, 2), Status::kQueueFull);

  EXPECT_EQ(Add(2, 3 * kHalf), Status::kQueued) << "one alone may be larger";
  EXPECT_EQ(Add(3, 3 * kHalf), Status::kQueueFull);
}

TEST_F(PartSenderTest, RefusesImplausibleAcknowledgements) {
  ASSERT_EQ(Add(1, 2), Status::kQueued);

  EXPECT_FALSE(Take(2 * kPartSize + 1));
  EXPECT_TRUE(Take(100));
  EXPECT_FALSE(Take(99));
}

TEST_F(PartSenderTest, CloseFreesAllFrames) {
  ASSERT_EQ(Add(1, 3 * kAhead), Status::kQueued);

  sender.Close();

  EXPECT_EQ(sender.waiting(), 0U);
  EXPECT_EQ(Add(1, 2), Status::kNotConnected);
  const std::size_t sent = link.sent.size();
  sender.Resume(link);
  EXPECT_EQ(link.sent.size(), sent);
}

}  // namespace
}  // namespace tendon
