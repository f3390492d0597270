#include <gtest/gtest.h>
#include <tendon/middleware/parts/part_assembly.h>
#include <tendon/middleware/parts/part_sender.h>
#include <tendon/middleware/parts/payload_limit.h>

namespace tendon {
namespace {

using Progress = PartAssembly::Progress;

/// A frame of so many bytes.
Bytes FrameOfSize(std::size_t size, std::byte fill = std::byte{1}) {
  FrameHeader header;
  header.type = static_cast<MessageType>(0x100);
  header.size = static_cast<std::uint32_t>(size - FrameHeader::kSize);
  Bytes frame;
  WriteFrame(header, Bytes(header.size, fill), frame);
  return frame;
}

/// The part of `frame` at that place.
std::span<const std::byte> PartOf(const Bytes& frame, std::size_t place) {
  const auto rest = std::span(frame).subspan(place * kPartSize);
  return rest.first(std::min(kPartSize, rest.size()));
}

TEST(PartAssembly, PutsPartsOfSeveralFramesTogether) {
  PartAssembly assembly;
  const Bytes first = FrameOfSize(2 * kPartSize + 1, std::byte{1});
  const Bytes second = FrameOfSize(2 * kPartSize, std::byte{2});
  Bytes whole;

  EXPECT_EQ(assembly.Add(1, PartOf(first, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(2, PartOf(second, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(1, PartOf(first, 1), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.Add(2, PartOf(second, 1), whole), Progress::kWhole);
  EXPECT_EQ(whole, second);
  EXPECT_EQ(assembly.Add(1, PartOf(first, 2), whole), Progress::kWhole);
  EXPECT_EQ(whole, first);

  EXPECT_EQ(assembly.claimed(), 0U);
  EXPECT_EQ(assembly.taken(), first.size() + second.size());
}

TEST(PartAssembly, AFrameMayBeOnePart) {
  PartAssembly assembly;
  const Bytes frame = FrameOfSize(100);
  Bytes whole;

  EXPECT_EQ(assembly.Add(1, frame, whole), Progress::kWhole);
  EXPECT_EQ(whole, frame);
}

TEST(PartAssembly, RefusesWhatIsNoPart) {
  const Bytes frame = FrameOfSize(2 * kPartSize);
  Bytes whole;
  Bytes foreign = frame;
  foreign[0] = std::byte{0};

  EXPECT_EQ(PartAssembly().Add(1, Bytes(10), whole), Progress::kNonsense);
  EXPECT_EQ(PartAssembly().Add(1, PartOf(foreign, 0), whole), Progress::kNonsense);
  EXPECT_EQ(PartAssembly().Add(1, std::span(frame).first(kPartSize - 1), whole),
            Progress::kNonsense);
  EXPECT_EQ(PartAssembly().Add(1, std::span(frame).first(kPartSize + 1), whole),
            Progress::kNonsense);
  EXPECT_EQ(PartAssembly().Add(1, Bytes(), whole), Progress::kNonsense);
  PartAssembly begun;
  ASSERT_EQ(begun.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(begun.Add(1, Bytes(3), whole), Progress::kNonsense);
}

TEST(PartAssembly, KeepsNoMoreThanOneSenderLetsOnItsWay) {
  PartAssembly assembly;
  Bytes whole;
  const Bytes largest = FrameOfSize(kMaxBodySize + FrameHeader::kSize);
  const Bytes window = FrameOfSize(kSendWindow);
  ASSERT_EQ(assembly.Add(1, PartOf(largest, 0), whole), Progress::kMoreToCome);
  ASSERT_EQ(assembly.Add(2, PartOf(window, 0), whole), Progress::kMoreToCome);

  EXPECT_EQ(assembly.Add(3, FrameOfSize(FrameHeader::kSize), whole), Progress::kNonsense);
  EXPECT_EQ(PartAssembly().Add(1, PartOf(FrameOfSize(largest.size() + 1), 0), whole),
            Progress::kNonsense);
}

TEST(PartAssembly, FreesWhatHasBegun) {
  PartAssembly assembly;
  Bytes whole;
  const Bytes frame = FrameOfSize(2 * kPartSize);
  ASSERT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
  EXPECT_EQ(assembly.claimed(), frame.size());

  assembly.Clear();

  EXPECT_EQ(assembly.claimed(), 0U);
  EXPECT_EQ(assembly.Add(1, PartOf(frame, 0), whole), Progress::kMoreToCome);
}

TEST(MaxPayload, IsNamedWithWhatExceedsIt) {
  EXPECT_EQ(ExceedsMaxPayload("'cloud'", 80'000'000, "robot/arm/Cloud"),
            (Error{ErrorCode::kInvalid,
                   "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B of robot/arm/Cloud"}));
  EXPECT_EQ(ExceedsMaxPayload("a message", 123).message,
            "a message of 123 B exceeds max_payload 67 108 864 B");
}

}  // namespace
}  // namespace tendon
