#include <gtest/gtest.h>
#include <tendon/base/clock.h>
#include <tendon/middleware/loopback.h>

#include "conformance/recorder.h"

namespace tendon {
namespace {

using conformance::FrameOf;
using conformance::Host;
using conformance::kTestTimeout;
using conformance::Recorder;

/// A server, a client, and a network with faults between them.
class FaultyLoopback : public testing::Test {
 protected:
  FaultyLoopback() {
    auto listening = server_.Listen("127.0.0.1:0", host_.accept());
    EXPECT_TRUE(listening);
    listener_ = *std::move(listening);
    address_ = listener_->address();
    const auto link = client_.Open(address_, recorder_, kTestTimeout);
    EXPECT_TRUE(link);
    link_ = *link;
  }
  void SendToServer(std::uint32_t first, std::uint32_t last) {
    for (auto i = first; i <= last; ++i) ASSERT_EQ(link_->Send(FrameOf(i)), Status::kQueued);
  }
  static std::uint32_t NumberOf(const loopback::Frame& frame) {
    return ReadFrameHeader(frame.bytes)->handle;
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  Host host_;
  const std::shared_ptr<Recorder> recorder_ = std::make_shared<Recorder>();
  LoopbackMiddleware server_{network_};
  LoopbackMiddleware client_{network_};
  std::unique_ptr<Listener> listener_;
  std::string address_;
  std::shared_ptr<Link> link_;
};

using Numbers = std::vector<std::uint32_t>;

TEST_F(FaultyLoopback, LosesFramesUnnoticedByTheSender) {
  network_->SetFaultInjector([](const loopback::Frame& frame) {
    return NumberOf(frame) % 2 == 0 ? loopback::kPass : loopback::kDrop;
  });

  SendToServer(0, 5);

  const auto guest = host_.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(3));
  EXPECT_EQ(guest.recorder->numbers(), (Numbers{0, 2, 4}));
}

TEST_F(FaultyLoopback, CanBeCutInOneDirection) {
  const auto guest = host_.guest();
  network_->SetFaultInjector([this](const loopback::Frame& frame) {
    return frame.to == address_ ? loopback::kDrop : loopback::kPass;
  });

  SendToServer(1, 1);
  ASSERT_EQ(guest.link->Send(FrameOf(2)), Status::kQueued);
  ASSERT_TRUE(recorder_->WaitForFrames(1));
  network_->SetFaultInjector([this](const loopback::Frame& frame) {
    return frame.from == address_ ? loopback::kDrop : loopback::kPass;
  });
  ASSERT_EQ(guest.link->Send(FrameOf(3)), Status::kQueued);
  SendToServer(4, 4);

  ASSERT_TRUE(guest.recorder->WaitForFrames(1));
  EXPECT_EQ(guest.recorder->numbers(), Numbers{4});
  EXPECT_EQ(recorder_->numbers(), Numbers{2});
}

TEST_F(FaultyLoopback, DelaysAFrameAndItsSuccessors) {
  constexpr std::chrono::milliseconds kDelay(50);
  network_->SetFaultInjector([&](const loopback::Frame& frame) {
    return NumberOf(frame) == 1 ? loopback::Fault{.delay = kDelay} : loopback::kPass;
  });
  const SteadyTime sent = SteadyClock().Now();

  SendToServer(1, 3);

  const auto guest = host_.guest();
  ASSERT_TRUE(guest.recorder->WaitForFrames(3));
  EXPECT_GE(SteadyClock().Now() - sent, kDelay);
  EXPECT_EQ(guest.recorder->numbers(), (Numbers{1, 2, 3}));
}

TEST_F(FaultyLoopback, HoldsFramesUntilTheyAreReleased) {
  const auto guest = host_.guest();
  network_->SetFaultInjector([](const loopback::Frame& frame) {
    return NumberOf(frame) == 2 ? loopback::kHold : loopback::kPass;
  });
  SendToServer(1, 3);
  ASSERT_TRUE(guest.recorder->WaitForFrames(1));
  ASSERT_EQ(guest.link->Send(FrameOf(7)), Status::kQueued);
  ASSERT_TRUE(recorder_->WaitForFrames(1));  // the other direction still works
  EXPECT_EQ(guest.recorder->numbers(), Numbers{1});

  network_->ReleaseHeld();

  ASSERT_TRUE(guest.recorder->WaitForFrames(3));
  EXPECT_EQ(guest.recorder->numbers(), (Numbers{1, 2, 3}));
}

TEST_F(FaultyLoopback, AStalledLinkBecomesFull) {
  network_->SetFaultInjector([](const loopback::Frame& /*frame*/) { return loopback::kHold; });
  const Bytes frame = FrameOf(1, 65536);
  Status status = Status::kQueued;

  for (std::size_t sent = 0; status && sent <= kSendWindow; sent += frame.size()) {
    status = link_->Send(frame);
  }

  EXPECT_EQ(status, Status::kQueueFull);
}

TEST_F(FaultyLoopback, ACrashedProcessIsLostToItsPeers) {
  const auto guest = host_.guest();

  server_.Crash();

  ASSERT_TRUE(recorder_->WaitForClosed());
  EXPECT_EQ(guest.link->Send(FrameOf(1)), Status::kNotConnected);
  EXPECT_EQ(guest.recorder->closed(), 0) << "the dead hear nothing";
  EXPECT_FALSE(client_.Open(address_, std::make_shared<Recorder>(), kTestTimeout));
  EXPECT_FALSE(server_.Open(address_, std::make_shared<Recorder>(), kTestTimeout));
}

TEST_F(FaultyLoopback, ASuccessorMayReuseTheAddress) {
  server_.Crash();
  LoopbackMiddleware successor(network_);
  Host host;
  const auto listener = successor.Listen(address_, host.accept());
  ASSERT_TRUE(listener);
  listener_.reset();  // the listener of the dead server

  const auto link = client_.Open(address_, std::make_shared<Recorder>(), kTestTimeout);

  ASSERT_TRUE(link);
  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);
  EXPECT_TRUE(host.guest().recorder->WaitForFrames(1));
}

TEST(Loopback, NetworksAreSeparate) {
  LoopbackMiddleware server(std::make_shared<LoopbackNetwork>());
  LoopbackMiddleware client(std::make_shared<LoopbackNetwork>());
  Host host;
  const auto listener = server.Listen("robot:10705", host.accept());
  ASSERT_TRUE(listener);

  const auto link = client.Open("robot:10705", std::make_shared<Recorder>(), kTestTimeout);

  ASSERT_FALSE(link);
  EXPECT_EQ(link.error(), (Error{ErrorCode::kUnreachable, "nobody listens at robot:10705"}));
}

TEST(Loopback, AProcessMayConnectToItself) {
  LoopbackMiddleware both(std::make_shared<LoopbackNetwork>());
  Host host;
  const auto listener = both.Listen("robot:0", host.accept());
  ASSERT_TRUE(listener);
  const auto link = both.Open((*listener)->address(), std::make_shared<Recorder>(), kTestTimeout);
  ASSERT_TRUE(link);

  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);

  EXPECT_TRUE(host.guest().recorder->WaitForFrames(1));
}

}  // namespace
}  // namespace tendon
