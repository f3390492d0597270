#include <gtest/gtest.h>
#include <support/peers/wrapped.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/loopback.h>

#include <atomic>
#include <future>
#include <memory>
#include <new>
#include <utility>

#include "support/wait.h"

namespace tendon {
namespace {

/// A link that refuses frames while it has no room.
class NarrowLink final : public test::WrappedLink {
 public:
  using WrappedLink::WrappedLink;

  Status Send(std::span<const std::byte> frame, Delivery delivery) override {
    if (is_memory_short.exchange(false)) throw std::bad_alloc();
    if (has_room) return WrappedLink::Send(frame, delivery);
    ++refused;
    return Status::kQueueFull;
  }

  std::atomic<bool> has_room{true};
  std::atomic<bool> is_memory_short{false};  // true: memory is exhausted at the next frame
  std::atomic<std::size_t> refused{0};
};

class NarrowMiddleware final : public test::WrappedMiddleware {
 public:
  explicit NarrowMiddleware(const std::shared_ptr<LoopbackNetwork>& network)
      : WrappedMiddleware(std::make_shared<LoopbackMiddleware>(network)) {}

  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    const auto opened = WrappedMiddleware::Open(address, std::move(handler), timeout);
    if (!opened) return opened.error();
    link = std::make_shared<NarrowLink>(*opened);
    return std::shared_ptr<Link>(link);
  }

  std::shared_ptr<NarrowLink> link;  // the last link that was opened
};

/// Counts the notices, and answers requests.
class Counting final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& /*peer*/) override {
    opened.set_value(channel);
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                std::span<const std::byte> /*body*/) override {
    ++notices;
  }
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> body, Responder responder) override {
    responder.Reply(body);
  }

  std::promise<std::weak_ptr<Channel>> opened;
  std::atomic<int> notices{0};
};

/// A channel whose opener sends over a narrow link.
class NarrowLinkTest : public testing::Test {
 protected:
  void SetUp() override {
    auto listener = server_.Listen(
        "127.0.0.1:0", Channel::Acceptor(HelloOf("robot"), [this] { return server_end_; }));
    ASSERT_TRUE(listener);
    listener_ = *std::move(listener);
    const auto channel = Channel::Open(client_, listener_->address(), HelloOf("desk"), client_end_,
                                       std::chrono::seconds(30));
    ASSERT_TRUE(channel);
    channel_ = *channel;
    auto opened = server_end_->opened.get_future();
    ASSERT_EQ(opened.wait_for(std::chrono::seconds(30)), std::future_status::ready);
    server_channel_ = opened.get().lock();
    ASSERT_TRUE(server_channel_);
  }
  void TearDown() override {
    channel_->Close();
    listener_.reset();
  }

  static Hello HelloOf(const std::string& name) {
    Hello hello;
    hello.name = name;
    hello.cookie = 4711;
    return hello;
  }
  static Status Tell(Channel& channel, std::size_t size) {
    return channel.Notify(static_cast<MessageType>(0x100), 0, Bytes(size), channel.NewLane());
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server_{network_};
  NarrowMiddleware client_{network_};
  const std::shared_ptr<Counting> server_end_ = std::make_shared<Counting>();
  const std::shared_ptr<Counting> client_end_ = std::make_shared<Counting>();
  std::unique_ptr<Listener> listener_;
  std::shared_ptr<Channel> channel_;
  std::shared_ptr<Channel> server_channel_;
};

TEST_F(NarrowLinkTest, SendingResumesWaitingParts) {
  client_.link->has_room = false;
  ASSERT_EQ(Tell(*channel_, 2 * kPartSize), Status::kQueued);
  client_.link->has_room = true;

  ASSERT_EQ(Tell(*channel_, 10), Status::kQueued);

  EXPECT_TRUE(EventuallyTrue([&] { return server_end_->notices == 2; }));
}

TEST_F(NarrowLinkTest, ExpireResumesWaitingParts) {
  client_.link->has_room = false;
  ASSERT_EQ(Tell(*channel_, 2 * kPartSize), Status::kQueued);
  client_.link->has_room = true;

  channel_->Expire(SteadyClock().Now());

  EXPECT_TRUE(EventuallyTrue([&] { return server_end_->notices == 1; }));
}

TEST_F(NarrowLinkTest, AFailedReplyIsRefusedAtOnce) {
  client_.link->is_memory_short = true;

  const auto reply =
      server_channel_->Call(static_cast<MessageType>(0x100), 0, Bytes(8), std::chrono::seconds(30));

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::kFailed) << reply.error().message;
}

TEST_F(NarrowLinkTest, AcknowledgesPartsAsSoonAsThereIsRoom) {
  constexpr std::size_t kAhead = PartSender::kPartsAhead + 1;  // number of parts
  client_.link->has_room = false;
  ASSERT_EQ(Tell(*server_channel_, 2 * kAhead * kPartSize), Status::kQueued);
  ASSERT_TRUE(EventuallyTrue([&] { return client_.link->refused >= kAhead; }));
  client_.link->has_room = true;

  channel_->Expire(SteadyClock().Now());

  EXPECT_TRUE(EventuallyTrue([&] { return client_end_->notices == 1; }));
}

}  // namespace
}  // namespace tendon
