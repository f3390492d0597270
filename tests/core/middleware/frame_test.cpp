#include <gtest/gtest.h>
#include <tendon/middleware/frame.h>

#include <cstring>

namespace tendon {
namespace {

Bytes Written(const FrameHeader& header, const Bytes& body) {
  Bytes frame;
  WriteFrame(header, body, frame);
  return frame;
}

FrameHeader HeaderOf(std::uint32_t size) {
  FrameHeader header;
  header.type = static_cast<MessageType>(0x1234);
  header.request = 0x1122334455667788;
  header.size = size;
  header.handle = 0xaabbccdd;
  return header;
}

TEST(Frame, TheHeaderHasAFixedLayout) {
  const Bytes frame = Written(HeaderOf(2), {std::byte{7}, std::byte{8}});

  constexpr unsigned char kNow = FrameHeader::kProtocolVersion;
  const unsigned char expected[] = {'T',  'N',  'D',  'N',  kNow, 0,    0x34, 0x12, 0x88,
                                    0x77, 0x66, 0x55, 0x44, 0x33, 0x22, 0x11, 2,    0,
                                    0,    0,    0xdd, 0xcc, 0xbb, 0xaa, 7,    8};
  ASSERT_EQ(frame.size(), sizeof(expected));
  EXPECT_EQ(std::memcmp(frame.data(), expected, sizeof(expected)), 0);
}

TEST(Frame, ReadsBackWhatWasWritten) {
  const auto header = ReadWholeFrame(Written(HeaderOf(3), Bytes(3)));

  ASSERT_TRUE(header);
  EXPECT_EQ(header->type, static_cast<MessageType>(0x1234));
  EXPECT_EQ(header->request, 0x1122334455667788U);
  EXPECT_EQ(header->handle, 0xaabbccddU);
  EXPECT_EQ(header->size, 3U);
}

TEST(Frame, ABufferKeepsItsMemory) {
  Bytes frame;
  frame.reserve(1000);
  const std::byte* memory = frame.data();

  WriteFrame(HeaderOf(500), Bytes(500), frame);
  WriteFrame(HeaderOf(0), Bytes(), frame);

  EXPECT_EQ(frame.data(), memory);
  EXPECT_EQ(frame.size(), FrameHeader::kSize);
}

TEST(Frame, RefusesATruncatedHeader) {
  const Bytes frame = Written(HeaderOf(0), {});
  for (std::size_t size = 0; size < FrameHeader::kSize; ++size) {
    EXPECT_FALSE(ReadFrameHeader(std::span(frame).first(size))) << size;
  }
  EXPECT_TRUE(ReadFrameHeader(frame));
}

TEST(Frame, RefusesAnotherMagicNumber) {
  Bytes frame = Written(HeaderOf(0), {});
  frame[0] = std::byte{'X'};

  EXPECT_FALSE(ReadFrameHeader(frame));
}

TEST(Frame, ReadsAHeaderOfAnotherVersion) {
  FrameHeader header = HeaderOf(0);
  header.version = 999;

  EXPECT_EQ(ReadFrameHeader(Written(header, {}))->version, 999);
}

TEST(Frame, RefusesASizeOverTheLimit) {
  Bytes frame = Written(HeaderOf(0), {});
  const auto with_size = [&](std::uint32_t size) {
    std::memcpy(frame.data() + offsetof(FrameHeader, size), &size, sizeof(size));
    return ReadFrameHeader(frame);
  };

  EXPECT_TRUE(with_size(kMaxFrameSize - FrameHeader::kSize));
  EXPECT_FALSE(with_size(kMaxFrameSize - FrameHeader::kSize + 1));
  EXPECT_FALSE(with_size(0xffffffffU));
}

TEST(Frame, RefusesAFrameOfAWrongSize) {
  Bytes frame = Written(HeaderOf(3), Bytes(3));

  frame.push_back({});
  EXPECT_FALSE(ReadWholeFrame(frame));
  frame.erase(frame.end() - 2, frame.end());
  EXPECT_FALSE(ReadWholeFrame(frame));
}

}  // namespace
}  // namespace tendon
