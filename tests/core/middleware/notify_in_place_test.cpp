#include <gtest/gtest.h>
#include <support/peers/traced_channel.h>
#include <tendon/middleware/part_sender.h>

#include "support/wait.h"

namespace tendon {
namespace {

constexpr auto kNews = static_cast<MessageType>(0x100);

/// Returns a frame with a body of `size` bytes. The header is left empty.
Bytes FrameWith(std::size_t size, int fill) {
  Bytes frame(FrameHeader::kSize);
  frame.resize(FrameHeader::kSize + size, static_cast<std::byte>(fill));
  return frame;
}
Bytes Filled(std::size_t size, int fill) { return Bytes(size, static_cast<std::byte>(fill)); }

using Notices = std::vector<test::TracedChannel::Notice>;

TEST(NotifyInPlace, SendsTheFrameWithoutACopy) {
  const test::TracedChannel channel;
  Bytes first = FrameWith(16, 1);
  Bytes second = FrameWith(0, 2);

  EXPECT_EQ(channel->NotifyInPlace(kNews, 7, first), Status(Status::kQueued));
  EXPECT_EQ(channel->NotifyInPlace(kNews, 8, second), Status(Status::kQueued));
  EXPECT_EQ(channel->NotifyInPlace(kNews, 9, first), Status(Status::kQueued)) << "once more";

  EXPECT_EQ(channel.PlacesOf(kNews),
            (std::vector<const std::byte*>{first.data(), second.data(), first.data()}));
  EXPECT_TRUE(EventuallyTrue([&] { return channel.notices().size() == 3; }));
  EXPECT_EQ(channel.notices(), (Notices{{7, Filled(16, 1)}, {8, {}}, {9, Filled(16, 1)}}));
}

TEST(NotifyInPlace, SendsALargeBodyInParts) {
  const test::TracedChannel channel;
  Bytes frame = FrameWith(2 * kPartSize, 3);

  EXPECT_EQ(channel->NotifyInPlace(kNews, 7, frame), Status(Status::kQueued));

  EXPECT_TRUE(EventuallyTrue([&] { return !channel.notices().empty(); }));
  EXPECT_EQ(channel.notices(), (Notices{{7, Filled(2 * kPartSize, 3)}}));
}

TEST(NotifyInPlace, WaitsBehindALargeMessageOfItsLane) {
  const test::TracedChannel channel;
  const Lane lane = channel->NewLane();
  Bytes small = FrameWith(8, 2);

  EXPECT_EQ(channel->Notify(kNews, 1, Bytes(2 * kPartSize), lane), Status(Status::kQueued));
  EXPECT_EQ(channel->NotifyInPlace(kNews, 2, small, lane), Status(Status::kQueued));

  EXPECT_TRUE(EventuallyTrue([&] { return channel.notices().size() == 2; }));
  EXPECT_EQ(channel.notices().back(), (Notices::value_type{2, Filled(8, 2)}));
}

TEST(NotifyInPlace, RefusesATooLargeBody) {
  const test::TracedChannel channel;
  Bytes frame(FrameHeader::kSize + kMaxBodySize + 1);

  EXPECT_EQ(channel->NotifyInPlace(kNews, 1, frame), Status(Status::kInvalid));

  EXPECT_TRUE(channel->is_open());
}

TEST(NotifyInPlace, SendsNothingOnAClosedChannel) {
  const test::TracedChannel channel;
  Bytes frame = FrameWith(8, 1);
  channel->Close();

  EXPECT_EQ(channel->NotifyInPlace(kNews, 1, frame), Status(Status::kNotConnected));

  EXPECT_TRUE(channel.PlacesOf(kNews).empty());
}

}  // namespace
}  // namespace tendon
