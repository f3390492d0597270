#include <gtest/gtest.h>
#include <support/machine/scarce_memory.h>
#include <tendon/middleware/part_assembly.h>
#include <tendon/middleware/part_sender.h>
#include <tendon/middleware/payload_limit.h>

namespace tendon {
namespace {

using Progress = PartAssembly::Progress;

/// Returns a frame of `size` bytes.
Bytes FrameOfSize(std::size_t size, std::byte fill = std::byte{1},
                  MessageType type = static_cast<MessageType>(0x100)) {
  FrameHeader header;
  header.type = type;
  header.size = static_cast<std::uint32_t>(size - FrameHeader::kSize);
  Bytes frame;
  WriteFrame(header, Bytes(header.size, fill), frame);
  return frame;
}

Bytes BodyOf(const Bytes& frame) { return {frame.begin() + FrameHeader::kSize, frame.end()}; }

/// Returns the part of `frame` with this index.
std::span<const std::byte> PartOf(const Bytes& frame, std::size_t place) {
  const auto rest = std::span(frame).subspan(place * kPartSize);
  return rest.first(std::min(kPartSize, rest.size()));
}

/// Expects that the assembled frame is equal to the sent frame.
void ExpectSame(const PartAssembly::Frame& whole, const Bytes& frame) {
  const auto sent = ReadWholeFrame(frame);
  ASSERT_TRUE(sent);
  EXPECT_EQ(whole.header.type, sent->type);
  EXPECT_EQ(whole.header.size, sent->size);
  EXPECT_EQ(whole.body, BodyOf(frame));
}

TEST(PartAssembly, AssemblesSeveralFrames) {
  PartAssembly assembly;
  const Bytes first = FrameOfSize(2 * kPartSize + 1, std::byte{1}, static_cast<MessageType>(0x101));
  const Bytes second = FrameOfSize(2 * kPartSize, std::byte{2}, static_cast<MessageType>(0x102));
  PartAssembly::Frame whole;

  EXPECT_EQ(assembly.Add(1, PartOf(first, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(2, PartOf(second, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(1, PartOf(first, 1), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(2, PartOf(second, 1), whole), Progress::kWhole);
  ExpectSame(whole, second);
  EXPECT_EQ(assembly.Add(1, PartOf(first, 2), whole), Progress::kWhole);
  ExpectSame(whole, first);

  EXPECT_EQ(assembly.claimed(), 0U);
  EXPECT_EQ(assembly.taken(), first.size() + second.size());
}

TEST(PartAssembly, AFrameMayBeOnePart) {
  PartAssembly assembly;
  const Bytes frame = FrameOfSize(100, std::byte{1}, static_cast<MessageType>(0x103));
  PartAssembly::Frame whole;

  EXPECT_EQ(assembly.Add(1, frame, whole), Progress::kWhole);
  ExpectSame(whole, frame);
}

TEST(PartAssembly, RefusesInvalidParts) {
  const Bytes frame = FrameOfSize(2 * kPartSize);
  PartAssembly::Frame whole;
  Bytes foreign = frame;
  foreign[0] = std::byte{0};

  EXPECT_EQ(PartAssembly().Add(1, Bytes(10), whole), Progress::kMalformed);
  EXPECT_EQ(PartAssembly().Add(1, PartOf(foreign, 0), whole), Progress::kMalformed);
  EXPECT_EQ(PartAssembly().Add(1, std::span(frame).first(kMinPartSize - 1), whole),
            Progress::kMalformed);
  EXPECT_EQ(PartAssembly().Add(1, Bytes(), whole), Progress::kMalformed);
  for (const MessageType type : {MessageType::kPartsTaken, MessageType::kHello, MessageType::kProof,
                                 MessageType::kReplies}) {
    EXPECT_EQ(PartAssembly().Add(1, FrameOfSize(100, std::byte{1}, type), whole),
              Progress::kMalformed);
  }
  PartAssembly begun;
  ASSERT_EQ(begun.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(begun.Add(1, Bytes(3), whole), Progress::kMalformed);
  EXPECT_EQ(begun.Add(1, Bytes(kPartSize + 1), whole), Progress::kMalformed);
}

TEST(PartAssembly, AssemblesPartsOfAllSizes) {
  PartAssembly assembly;
  const Bytes frame = FrameOfSize(4 * kMinPartSize + 1);
  const auto rest = std::span(frame);
  PartAssembly::Frame whole;

  EXPECT_EQ(assembly.Add(1, rest.first(2 * kMinPartSize), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(1, rest.subspan(2 * kMinPartSize, kMinPartSize), whole),
            Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(1, rest.subspan(3 * kMinPartSize), whole), Progress::kWhole);
  EXPECT_EQ(whole.body, BodyOf(frame));
}

TEST(PartAssembly, HoldsNoMoreThanASenderMaySend) {
  PartAssembly assembly;
  PartAssembly::Frame whole;
  const Bytes largest = FrameOfSize(kMaxBodySize + FrameHeader::kSize);
  const Bytes window = FrameOfSize(kSendWindow);
  ASSERT_EQ(assembly.Add(1, PartOf(largest, 0), whole), Progress::kMoreToCome);
  ASSERT_EQ(assembly.Add(2, PartOf(window, 0), whole), Progress::kMoreToCome);

  EXPECT_EQ(assembly.Add(3, FrameOfSize(FrameHeader::kSize), whole), Progress::kMalformed);
  EXPECT_EQ(PartAssembly().Add(1, PartOf(FrameOfSize(largest.size() + 1), 0), whole),
            Progress::kMalformed);
}

TEST(PartAssembly, HoldsOneHugeFrameOrAWindow) {
  PartAssembly huge;
  PartAssembly assembly;
  PartAssembly::Frame whole;
  const Bytes giant = FrameOfSize(kSendWindow + 1);
  const Bytes half = FrameOfSize(kSendWindow / 2);

  EXPECT_EQ(huge.Add(1, PartOf(giant, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(huge.Add(2, PartOf(giant, 0), whole), Progress::kMalformed);
  EXPECT_EQ(assembly.Add(1, PartOf(half, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(2, PartOf(half, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(3, PartOf(half, 0), whole), Progress::kMalformed);
}

TEST(PartAssembly, DiscardsUnwantedFrames) {
  const Bytes frame = FrameOfSize(2 * kPartSize);
  const Bytes other = FrameOfSize(100);
  Budget<> none(0);
  ASSERT_TRUE(none.Take(1));
  PartAssembly assembly([](const FrameHeader& /*header*/) { return false; }, none);
  PartAssembly::Frame whole;

  EXPECT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(1, PartOf(frame, 1), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.claimed(), 0U) << "it is over";
  EXPECT_EQ(assembly.Add(2, other, whole), Progress::kWhole) << "what is small is not asked for";
  EXPECT_EQ(assembly.taken(), frame.size() + other.size());
}

TEST(PartAssembly, AssembliesOfOneBudgetStayWithinIt) {
  Budget<> budget(2 * kPartSize);
  PartAssembly first(nullptr, budget);
  const Bytes frame = FrameOfSize(4 * kPartSize);
  PartAssembly::Frame whole;
  ASSERT_EQ(first.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  ASSERT_EQ(first.Add(1, PartOf(frame, 1), whole), Progress::kMoreToCome);
  {
    PartAssembly second(nullptr, budget);
    EXPECT_EQ(second.Add(1, PartOf(frame, 0), whole), Progress::kTooMuch);
    EXPECT_EQ(whole.header.size, frame.size() - FrameHeader::kSize);
  }

  first.Clear();

  PartAssembly third(nullptr, budget);
  EXPECT_EQ(third.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
}

TEST(PartAssembly, CompleteFramesLeaveTheBudget) {
  Budget<> budget(kPartSize);
  PartAssembly assembly(nullptr, budget);
  const Bytes frame = FrameOfSize(2 * kPartSize);
  PartAssembly::Frame whole;

  for (std::uint32_t number = 1; number < 4; ++number) {
    EXPECT_EQ(assembly.Add(number, PartOf(frame, 0), whole), Progress::kMoreToCome);
    EXPECT_EQ(assembly.Add(number, PartOf(frame, 1), whole), Progress::kWhole);
  }
}

TEST(PartAssembly, AllocatesForReceivedBytesOnly) {
  PartAssembly assembly;
  PartAssembly::Frame whole;
  const Bytes frame = FrameOfSize(kMaxBodySize + FrameHeader::kSize);
  const ScarceMemory scarce(kMaxBodySize);

  EXPECT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  auto progress = Progress::kMoreToCome;
  for (std::size_t place = 1; progress == Progress::kMoreToCome; ++place) {
    progress = assembly.Add(1, PartOf(frame, place), whole);
  }

  EXPECT_EQ(progress, Progress::kOutOfMemory);
  EXPECT_EQ(whole.header.size, kMaxBodySize);
}

TEST(PartAssembly, TimesOutAFrameWithoutFurtherParts) {
  ManualClock clock;
  PartAssembly assembly(nullptr, PartAssembly::BudgetOfProcess(), clock);
  const Bytes frame = FrameOfSize(3 * kPartSize);
  PartAssembly::Frame whole;
  EXPECT_EQ(assembly.given_up(), SteadyTime::max());

  ASSERT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  const SteadyTime first = clock.Now();
  EXPECT_EQ(assembly.given_up(), first + PartAssembly::kPartTimeout + PartSender::kPartTime);
  clock.Advance(std::chrono::seconds(1));
  ASSERT_EQ(assembly.Add(2, PartOf(frame, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.given_up(), first + PartAssembly::kPartTimeout + 2 * PartSender::kPartTime);
  ASSERT_EQ(assembly.Add(1, PartOf(frame, 1), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.given_up(),
            clock.Now() + PartAssembly::kPartTimeout + 2 * PartSender::kPartTime);
  ASSERT_EQ(assembly.Add(1, PartOf(frame, 2), whole), Progress::kWhole);
  ASSERT_EQ(assembly.Add(2, PartOf(frame, 1), whole), Progress::kMoreToCome);
  ASSERT_EQ(assembly.Add(2, PartOf(frame, 2), whole), Progress::kWhole);

  EXPECT_EQ(assembly.given_up(), SteadyTime::max());
}

TEST(PartAssembly, ClearFreesUnfinishedFrames) {
  PartAssembly assembly;
  PartAssembly::Frame whole;
  const Bytes frame = FrameOfSize(2 * kPartSize);
  ASSERT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.claimed(), frame.size());

  assembly.Clear();

  EXPECT_EQ(assembly.claimed(), 0U);
  EXPECT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
}

TEST(MaxPayload, ErrorsNameTheLimitAndTheExcess) {
  EXPECT_EQ(ExceedsMaxPayload("'cloud'", 80'000'000, "robot/arm/Cloud"),
            (Error{ErrorCode::kInvalid,
                   "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B of robot/arm/Cloud"}));
  EXPECT_EQ(ExceedsMaxPayload("a message", 123).message,
            "a message of 123 B exceeds max_payload 67 108 864 B");
}

}  // namespace
}  // namespace tendon
