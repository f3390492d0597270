#include <gmock/gmock.h>
#include <tendon/middleware/parts/part_assembly.h>
#include <tendon/middleware/parts/part_sender.h>
#include <tendon/middleware/parts/payload_limit.h>

#include <vector>

namespace tendon {
namespace {

using testing::ElementsAre;

/// Keeps what is sent while it has room.
class FakeLink final : public Link {
 public:
  Status Send(std::span<const std::byte> frame) override {
    if (!has_room) return Status::kQueueFull;
    const auto header = ReadWholeFrame(frame);
    EXPECT_TRUE(header && header->type == MessageType::kPart && frame.size() <= kMaxPieceSize);
    sent.push_back(header->handle);
    bytes += header->size;
    return Status::kQueued;
  }
  void Admit() override {}
  void Close() override {}
  [[nodiscard]] std::string peer() const override { return "peer"; }
  [[nodiscard]] std::string local() const override { return "local"; }

  bool has_room = true;
  std::vector<std::uint32_t> sent;  // by frame
  std::uint64_t bytes = 0;
};

constexpr std::size_t kAhead = PartSender::kPartsAhead / kPartSize + 1;  // parts

class PartSenderTest : public testing::Test {
 protected:
  /// A frame of so many parts.
  Status Add(Lane lane, std::size_t parts) {
    FrameHeader header;
    header.type = static_cast<MessageType>(0x100);
    const Bytes body(parts * kPartSize - FrameHeader::kSize);
    header.size = static_cast<std::uint32_t>(body.size());
    return sender.Add(link, lane, header, body);
  }

  PartSender sender;
  FakeLink link;
};

TEST_F(PartSenderTest, TakesWhatIsLargeOrBehindALargeOneOfItsLane) {
  EXPECT_FALSE(sender.MustTake(1, kMaxPieceSize));
  EXPECT_TRUE(sender.MustTake(1, kMaxPieceSize + 1));

  ASSERT_EQ(Add(1, 2 * kAhead), Status::kQueued);

  EXPECT_TRUE(sender.MustTake(1, 30));
  EXPECT_FALSE(sender.MustTake(2, 30));
  EXPECT_FALSE(sender.MustTake(kCommonLane, 30));
  EXPECT_FALSE(sender.MustTake(kOwnLane, 30));
}

TEST_F(PartSenderTest, SendsNoFurtherAheadThanThePeerHasTaken) {
  ASSERT_EQ(Add(1, 3 * kAhead), Status::kQueued);
  EXPECT_EQ(link.sent.size(), kAhead);

  EXPECT_TRUE(sender.OnTaken(link, kPartSize));
  EXPECT_EQ(link.sent.size(), kAhead + 1);

  EXPECT_TRUE(sender.OnTaken(link, link.bytes));
  EXPECT_EQ(link.sent.size(), 2 * kAhead + 1);
}

TEST_F(PartSenderTest, TakesTheLanesInTurnAndEachInOrder) {
  link.has_room = false;
  ASSERT_EQ(Add(1, 3), Status::kQueued);
  ASSERT_EQ(Add(2, 1), Status::kQueued);
  ASSERT_EQ(Add(2, 1), Status::kQueued);
  link.has_room = true;

  sender.Resume(link);

  EXPECT_THAT(link.sent, ElementsAre(1, 2, 1, 3, 1));
  EXPECT_FALSE(sender.MustTake(1, 30));
}

TEST_F(PartSenderTest, GoesOnWhereTheLinkHadNoRoom) {
  link.has_room = false;
  ASSERT_EQ(Add(1, 2), Status::kQueued);
  sender.Resume(link);
  EXPECT_TRUE(link.sent.empty());

  link.has_room = true;
  sender.Resume(link);

  EXPECT_THAT(link.sent, ElementsAre(1, 1));
}

TEST_F(PartSenderTest, CountsAFrameUntilThePeerHasTakenItsEnd) {
  ASSERT_EQ(Add(1, 2), Status::kQueued);
  EXPECT_EQ(sender.waiting(), 2 * kPartSize);

  EXPECT_TRUE(sender.OnTaken(link, kPartSize));
  EXPECT_EQ(sender.waiting(), 2 * kPartSize);
  EXPECT_TRUE(sender.OnTaken(link, 2 * kPartSize));
  EXPECT_EQ(sender.waiting(), 0U);
}

TEST_F(PartSenderTest, RefusesWhatExceedsTheWindow) {
  constexpr std::size_t kHalf = kSendWindow / kPartSize / 2;
  EXPECT_EQ(Add(1, kHalf), Status::kQueued);
  EXPECT_EQ(Add(1, kHalf), Status::kQueued);
  EXPECT_EQ(Add(2, 2), Status::kQueueFull);

  EXPECT_EQ(Add(2, 3 * kHalf), Status::kQueued) << "one alone may be larger";
  EXPECT_EQ(Add(3, 3 * kHalf), Status::kQueueFull);
}

TEST_F(PartSenderTest, DoesNotBelieveThatMoreWasTakenThanWasSentOrThatItWasGivenBack) {
  ASSERT_EQ(Add(1, 2), Status::kQueued);

  EXPECT_FALSE(sender.OnTaken(link, 2 * kPartSize + 1));
  EXPECT_TRUE(sender.OnTaken(link, 100));
  EXPECT_FALSE(sender.OnTaken(link, 99));
}

TEST_F(PartSenderTest, FreesAllWhenTheLinkEnds) {
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
