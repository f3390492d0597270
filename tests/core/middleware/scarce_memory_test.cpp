#include <gmock/gmock.h>
#include <support/machine/scarce_memory.h>
#include <tendon/base/os/socket.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/tcp.h>

#include <atomic>
#include <future>
#include <new>
#include <span>
#include <vector>

#include "conformance/recorder.h"

namespace tendon {
namespace {

using conformance::FrameOf;
using conformance::Host;
using conformance::kTestTimeout;
using conformance::Recorder;
using testing::HasSubstr;

constexpr std::size_t kLarge = std::size_t{100} << 10U;

/// A listener with an open link, and the socket of a second open link.
class LowMemory : public testing::Test {
 protected:
  void SetUp() override {
    auto listener = middleware_->Listen("127.0.0.1:0", host_.accept());
    ASSERT_TRUE(listener);
    listener_ = *std::move(listener);
    const auto link = middleware_->Open(listener_->address(), old_recorder_, kTestTimeout);
    ASSERT_TRUE(link);
    old_ = *link;
    ASSERT_NE(host_.guest(0).link, nullptr);
    socket_ = Connect();
    ASSERT_NE(host_.guest(1).link, nullptr);
  }
  void TearDown() override { listener_.reset(); }

  os::Socket Connect() {
    const auto place = ParseAddress(listener_->address(), 1);
    auto connected = os::ConnectTo(place->host, place->port, kTestTimeout);
    EXPECT_TRUE(connected);
    return *std::move(connected);
  }

  void ExpectFirstLinkWorks() {
    ASSERT_EQ(old_->Send(FrameOf(7)), Status::kQueued);
    EXPECT_TRUE(host_.guest(0).recorder->WaitForFrames(1));
    EXPECT_EQ(old_recorder_->closed(), 0);
  }

  const std::shared_ptr<Middleware> middleware_ = MakeTcpMiddleware(Exposure::kLoopbackOnly);
  Host host_;
  std::unique_ptr<Listener> listener_;
  const std::shared_ptr<Recorder> old_recorder_ = std::make_shared<Recorder>();
  std::shared_ptr<Link> old_;
  os::Socket socket_;
};

TEST_F(LowMemory, ClosesALinkThatExhaustsMemory) {
  const Bytes frame = FrameOf(1, kLarge);
  const auto guest = host_.guest(1);
  {
    const ScarceMemory scarce(kLarge / 2);

    ASSERT_TRUE(os::SendSome(socket_, std::span(frame).first(kLarge - 1)));

    ASSERT_TRUE(guest.recorder->WaitForClosed());
  }
  EXPECT_EQ(guest.recorder->reason().code, ErrorCode::kFailed);
  EXPECT_THAT(guest.recorder->reason().message, HasSubstr("out of memory (ulimit -v)"));
  ExpectFirstLinkWorks();
}

TEST_F(LowMemory, RefusesNewcomersUntilMemoryIsFree) {
  Bytes buffer(100);
  {
    const ScarceMemory scarce(256);
    const os::Socket connecting = Connect();

    EXPECT_TRUE(EventuallyTrue([&] { return !os::ReceiveSome(connecting, buffer); }));
  }
  EXPECT_EQ(host_.count(), 2U);
  const os::Socket later = Connect();
  EXPECT_NE(host_.guest(2).link, nullptr);
  ExpectFirstLinkWorks();
}

TEST_F(LowMemory, SendsNothingAfterAPartialFrame) {
  std::promise<void> go_on;
  std::atomic<bool> is_deaf = false;
  Host deaf([&is_deaf, gone_on = go_on.get_future().share()](const std::shared_ptr<Link>& /*to*/) {
    return std::make_shared<Recorder>([&is_deaf, gone_on](std::span<const std::byte> /*frame*/) {
      is_deaf = true;
      gone_on.wait();
    });
  });
  const auto server = MakeTcpMiddleware(Exposure::kLoopbackOnly);
  const auto listener = server->Listen("127.0.0.1:0", deaf.accept());
  ASSERT_TRUE(listener);
  const auto recorder = std::make_shared<Recorder>();
  const auto link = middleware_->Open((*listener)->address(), recorder, kTestTimeout);
  ASSERT_TRUE(link);
  const Bytes frame = FrameOf(1, kLarge);
  std::size_t sent = 1;
  ASSERT_EQ((*link)->Send(FrameOf(1)), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return is_deaf.load(); }));
  {
    const ScarceMemory scarce(1024);
    const auto fill = [&] {
      while ((*link)->Send(frame)) ++sent;
    };
    EXPECT_THROW(fill(), std::bad_alloc);
  }

  const Status next = (*link)->Send(FrameOf(2));
  go_on.set_value();

  const auto guest = deaf.guest();
  EXPECT_TRUE(guest.recorder->WaitForFrames(sent + (next ? 1 : 0)));
  EXPECT_EQ(guest.recorder->numbers().back(), next ? 2U : 1U);
  EXPECT_TRUE(next || recorder->WaitForClosed());
}

/// Its OnClosed() throws, because memory is exhausted.
class Overwhelmed final : public LinkHandler {
 public:
  void OnFrame(std::span<const std::byte> /*frame*/) override {}
  void OnClosed(const Error& /*reason*/) override { throw std::bad_alloc(); }
};

TEST(TcpLowMemory, StoppingClosesAllLinksDespiteThrowingHandlers) {
  const auto middleware = MakeTcpMiddleware(Exposure::kLoopbackOnly);
  auto listener = middleware->Listen("127.0.0.1:0", [](const std::shared_ptr<Link>& link) {
    link->Admit();
    return std::make_shared<Overwhelmed>();
  });
  ASSERT_TRUE(listener);
  std::vector<std::shared_ptr<Recorder>> recorders(3);
  std::vector<std::shared_ptr<Link>> links;
  for (auto& recorder : recorders) {
    recorder = std::make_shared<Recorder>();
    const auto link = middleware->Open((*listener)->address(), recorder, kTestTimeout);
    ASSERT_TRUE(link);
    links.push_back(*link);
  }

  (*listener).reset();

  for (const auto& recorder : recorders) EXPECT_TRUE(recorder->WaitForClosed());
}

/// Answers with this number of bytes, which are allocated already.
class Answerer final : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> /*body*/, Responder responder) override {
    responder.Reply(answer_);
  }

 private:
  const Bytes answer_ = Bytes(8000, std::byte{7});
};

TEST(ChannelLowMemory, LosesOnlyTheReplyThatDoesNotFit) {
  constexpr auto kAsk = static_cast<MessageType>(0x101);
  const Hello hello{.instance = 1, .name = "robot", .cookie = 7};
  const auto middleware = MakeTcpMiddleware(Exposure::kLoopbackOnly);
  const auto listener = middleware->Listen(
      "127.0.0.1:0", Channel::Acceptor(hello, [] { return std::make_shared<Answerer>(); }));
  ASSERT_TRUE(listener);
  const auto channel = Channel::Open(*middleware, (*listener)->address(), hello,
                                     std::make_shared<ChannelHandler>(), kTestTimeout);
  ASSERT_TRUE(channel);
  ASSERT_TRUE((*channel)->Call(kAsk, 0, Bytes{}, kTestTimeout)) << "it needs no memory to send now";
  {
    const ScarceMemory scarce(8000);

    const auto answer = (*channel)->Call(kAsk, 0, Bytes{}, kTestTimeout);

    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().message, HasSubstr("there is not enough memory for the reply"));
  }
  EXPECT_TRUE((*channel)->Call(kAsk, 0, Bytes{}, kTestTimeout));
}

}  // namespace
}  // namespace tendon
