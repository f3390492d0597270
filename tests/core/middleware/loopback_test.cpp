#include <gtest/gtest.h>
#include <tendon/middleware/loopback.h>

#include "conformance/recorder.h"

namespace tendon {
namespace {

using conformance::FrameOf;
using conformance::Host;
using conformance::kPatience;
using conformance::Recorder;

TEST(Loopback, TheFilterLosesFramesAndTheSenderDoesNotNotice) {
  const auto network = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server(network);
  LoopbackMiddleware client(network);
  Host host;
  const auto listener = server.Listen("127.0.0.1:0", host.accept());
  ASSERT_TRUE(listener);
  const auto link = client.Open((*listener)->address(), std::make_shared<Recorder>(), kPatience);
  ASSERT_TRUE(link);
  network->SetFilter(
      [](std::span<const std::byte> frame) { return ReadFrameHeader(frame)->handle % 2 == 0; });

  for (std::uint32_t i = 0; i < 6; ++i) EXPECT_EQ((*link)->Send(FrameOf(i)), Status::kQueued);

  const auto guest = host.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(3));
  EXPECT_EQ(guest.recorder->numbers(), (std::vector<std::uint32_t>{0, 2, 4}));
}

TEST(Loopback, NetworksDoNotKnowEachOther) {
  LoopbackMiddleware server(std::make_shared<LoopbackNetwork>());
  LoopbackMiddleware client(std::make_shared<LoopbackNetwork>());
  Host host;
  const auto listener = server.Listen("robot:10705", host.accept());
  ASSERT_TRUE(listener);

  const auto link = client.Open("robot:10705", std::make_shared<Recorder>(), kPatience);

  ASSERT_FALSE(link);
  EXPECT_EQ(link.error(), (Error{ErrorCode::kUnreachable, "nobody listens at robot:10705"}));
}

TEST(Loopback, AProcessMayTalkToItself) {
  LoopbackMiddleware both(std::make_shared<LoopbackNetwork>());
  Host host;
  const auto listener = both.Listen("robot:0", host.accept());
  ASSERT_TRUE(listener);
  const auto link = both.Open((*listener)->address(), std::make_shared<Recorder>(), kPatience);
  ASSERT_TRUE(link);

  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);

  EXPECT_TRUE(host.guest().recorder->WaitForFrames(1));
}

}  // namespace
}  // namespace tendon
