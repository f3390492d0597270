#include <atomic>
#include <future>
#include <mutex>

#include "conformance/contract.h"
#include "conformance/oracle.h"

namespace tendon::conformance {
namespace {

constexpr auto kHowMany = static_cast<MessageType>(0x111);
constexpr auto kOfSize = static_cast<MessageType>(0x112);
constexpr auto kTellThenReply = static_cast<MessageType>(0x113);
constexpr auto kReplyTwice = static_cast<MessageType>(0x114);

/// Answers requests of some types at once, in the lane kOwnLane, as reads are answered. Keeps all
/// other requests.
class PromptClerk final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& /*peer*/) override {
    opened_.set_value(channel);
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                std::span<const std::byte> /*body*/) override {
    ++notices_;
  }
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type == kHowMany) return responder.Reply(EncodeBody(notices_.load()), kOwnLane);
    if (header.type == kOfSize) return responder.Reply(Bytes(header.handle, body[0]), kOwnLane);
    if (header.type == kThrow) throw std::runtime_error("the clerk is tired");
    if (header.type == kTellThenReply) {
      (void)channel->Notify(kTell, 0, None{});
      return responder.Reply(body, kOwnLane);
    }
    if (header.type == kReplyTwice) {
      responder.Reply(EncodeBody(std::uint32_t{1}), kOwnLane);
      has_replied_twice_ = responder.TryReply(EncodeBody(std::uint32_t{2}), kOwnLane);
      return;
    }
    const std::scoped_lock turn(gate_);
    kept_.push_back(std::move(responder));
    ++has_kept_;
  }

  std::promise<std::shared_ptr<Channel>> opened_;
  std::atomic<std::uint32_t> notices_{0};
  std::atomic<int> has_kept_{0};
  std::atomic<bool> has_replied_twice_{false};
  std::mutex gate_;  // while this is locked, the handler of a kept request blocks
  std::vector<Responder> kept_;
};

/// Sends a request and waits for the reply, which may take the direct path.
Result<Bytes> SendRequest(Channel& channel, MessageType type, std::uint32_t handle = 0,
                          std::chrono::milliseconds timeout = kLong) {
  auto reply = channel.Call(type, handle, EncodeBody(std::uint32_t{7}), timeout, kOwnLane,
                            Delivery::kDirect);
  if (!reply) return reply.error();
  return (*std::move(reply)).TakeBytes();
}

std::future<Result<Bytes>> AskToBeKept(Channel& channel, PromptClerk& clerk) {
  auto reply = std::async(std::launch::async, [&] { return SendRequest(channel, kKeep); });
  EXPECT_TRUE(EventuallyTrue([&] { return clerk.has_kept_ == 1; }));
  return reply;
}

TEST_P(ChannelContract, ADirectRequestMayBeAnsweredAtOnceOrLater) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());
  EXPECT_EQ(*SendRequest(*channel_, kHowMany), EncodeBody(std::uint32_t{0}));

  auto reply = AskToBeKept(*channel_, *server);
  EXPECT_EQ(*SendRequest(*channel_, kHowMany),
            EncodeBody(std::uint32_t{0}));  // other requests are not blocked
  server->kept_.front().Reply(EncodeBody(std::uint32_t{3}), kOwnLane);

  EXPECT_EQ(*reply.get(), EncodeBody(std::uint32_t{3}));
}

TEST_P(ChannelContract, DirectRequestsKeepTheOrderOfMessages) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());
  constexpr std::uint32_t kRounds = 300;
  std::mutex mutex;
  std::vector<std::uint32_t> heard;

  for (std::uint32_t i = 0; i < kRounds; ++i) {
    ASSERT_TRUE(channel_->Notify(kTell, 0, None{}));
    const Status asked = channel_->TryRequest(
        kHowMany, 0, {}, kLong,
        [&](Result<Bytes> reply) {
          const std::scoped_lock lock(mutex);
          heard.push_back(reply ? *DecodeBody<std::uint32_t>(*reply) : 0);
        },
        kOwnLane, Delivery::kDirect);
    ASSERT_TRUE(asked);
  }

  ASSERT_TRUE(EventuallyTrue([&] {
    const std::scoped_lock lock(mutex);
    return heard.size() == kRounds;
  }));
  for (std::uint32_t i = 0; i < kRounds; ++i) EXPECT_EQ(heard[i], i + 1);
}

TEST_P(ChannelContract, DirectRepliesFollowEarlierMessages) {
  const auto client = std::make_shared<PromptClerk>();
  Connect(std::make_shared<PromptClerk>(), client);
  for (std::uint32_t i = 1; i <= 50; ++i) {
    std::promise<std::uint32_t> told;
    ASSERT_TRUE(channel_->TryRequest(
        kTellThenReply, 0, {}, kLong,
        [&](Result<Bytes> reply) { told.set_value(reply ? client->notices_.load() : 0); }, kOwnLane,
        Delivery::kDirect));
    EXPECT_EQ(told.get_future().get(), i);
  }
}

TEST_P(ChannelContract, DirectRepliesOfAllSizesArriveComplete) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());
  // The largest body that fits into one piece.
  constexpr std::size_t kLargest = kMaxPieceSize - FrameHeader::kSize;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{253}, kLargest - 1,
                                 kLargest, kLargest + 1, 4 * kLargest}) {
    const auto reply = SendRequest(*channel_, kOfSize, static_cast<std::uint32_t>(size));

    ASSERT_TRUE(reply) << reply.error().message;
    EXPECT_EQ(*reply, Bytes(size, std::byte{7}));
  }
}

TEST_P(ChannelContract, ADirectRequestLargerThanAPieceIsAnswered) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());

  const auto reply = channel_->Call(kTellThenReply, 0, Bytes(3 * kMaxPieceSize), kLong, kOwnLane,
                                    Delivery::kDirect);

  ASSERT_TRUE(reply) << reply.error().message;
  EXPECT_EQ(reply->body().size(), 3 * kMaxPieceSize);
}

TEST_P(ChannelContract, OnlyTheFirstDirectReplyIsSent) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());

  EXPECT_EQ(*SendRequest(*channel_, kReplyTwice), EncodeBody(std::uint32_t{1}));

  EXPECT_TRUE(SendRequest(*channel_, kHowMany));
  EXPECT_FALSE(server->has_replied_twice_);
}

TEST_P(ChannelContract, AThrowingHandlerRefusesADirectRequest) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());

  const auto reply = SendRequest(*channel_, kThrow);

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::kFailed);
  EXPECT_TRUE(SendRequest(*channel_, kHowMany));
}

TEST_P(ChannelContract, DirectRequestsToAHungPeerEndAtTheirDeadline) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());
  std::unique_lock hung(server->gate_);

  const auto reply = SendRequest(*channel_, kKeep, 0, std::chrono::milliseconds(30));
  const auto next = SendRequest(*channel_, kHowMany, 0, std::chrono::milliseconds(30));

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().message, "no reply from robot within 30 ms; outcome unknown");
  EXPECT_FALSE(next);
  hung.unlock();
  EXPECT_TRUE(
      SendRequest(*channel_, kHowMany));  // arrives after the late reply to the earlier kHowMany
  hung.lock();
  Responder kept = std::move(server->kept_.front());
  hung.unlock();
  kept.Reply({}, kOwnLane);
  EXPECT_TRUE(SendRequest(*channel_, kHowMany));
}

TEST_P(ChannelContract, ClosingTheLinkEndsADirectRequest) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());
  auto reply = AskToBeKept(*channel_, *server);

  server->opened_.get_future().get()->Close();

  const auto outcome = reply.get();
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::kUnreachable);
  EXPECT_EQ(SendRequest(*channel_, kHowMany).error().code, ErrorCode::kUnreachable);
}

TEST_P(ChannelContract, BothEndsMaySendDirectRequestsConcurrently) {
  const auto server = std::make_shared<PromptClerk>();
  Connect(server, std::make_shared<PromptClerk>());
  const auto back = server->opened_.get_future().get();
  std::atomic<int> replies{0};

  auto there = std::async(std::launch::async, [&] {
    for (int i = 0; i < 200; ++i)
      replies += static_cast<int>(SendRequest(*channel_, kHowMany).ok());
  });
  for (int i = 0; i < 200; ++i) {
    replies +=
        static_cast<int>(back->Call(kHowMany, 0, {}, kLong, kOwnLane, Delivery::kDirect).ok());
  }
  there.get();

  EXPECT_EQ(replies, 400);
}

}  // namespace
}  // namespace tendon::conformance
