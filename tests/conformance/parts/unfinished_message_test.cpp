#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "conformance/contract.h"
#include "conformance/oracle.h"
#include "conformance/parts/halting_middleware.h"

namespace tendon::conformance {
namespace {

using testing::IsEmpty;

constexpr std::size_t kThreeMebibytes = std::size_t{3} << 20U;
constexpr auto kForbidden = static_cast<MessageType>(0x10f);

/// Refuses large messages of one type, and records the messages of this type that arrive complete.
class Choosy final : public ChannelHandler {
 public:
  void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& /*peer*/) override {
    const std::scoped_lock lock(mutex_);
    channel_ = channel;
  }
  std::optional<Error> RefusalOfLargeMessage(const Channel& /*channel*/,
                                             const FrameHeader& header) override {
    if (header.type != kForbidden) return std::nullopt;
    return Error{ErrorCode::kDenied, "nobody may send it"};
  }
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type == kForbidden) ++came_;
    responder.Reply(body.first(std::min<std::size_t>(body.size(), 1)));
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> /*body*/) override {
    if (header.type == kForbidden) ++came_;
  }
  void OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    channel_.reset();
    reason_ = reason.message;
  }

  [[nodiscard]] std::shared_ptr<Channel> channel() const {
    const std::scoped_lock lock(mutex_);
    return channel_;
  }
  [[nodiscard]] std::string reason() const {
    const std::scoped_lock lock(mutex_);
    return reason_;
  }
  [[nodiscard]] int came() const { return came_; }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<Channel> channel_;
  std::string reason_;
  std::atomic<int> came_{0};
};

bool Answers(Channel& channel) { return channel.Call(kAsk, 0, Bytes(7), kLong).ok(); }

TEST_P(LargeMessageContract, AStalledMessageClosesTheChannel) {
  const auto server = std::make_shared<Choosy>();
  Start(Channel::Acceptor(HelloOf("robot"), [server] { return server; }));
  HaltingMiddleware halting(pair_.client, 3);
  const auto channel = Channel::Open(halting, listener_->address(), HelloOf("desk"),
                                     std::make_shared<ChannelHandler>(), kTestTimeout);
  ASSERT_TRUE(channel) << channel.error().message;
  ASSERT_EQ((*channel)->Notify(kTell, 0, Bytes(kThreeMebibytes), kOwnLane), Status::kQueued);
  ASSERT_TRUE(Answers(**channel)) << "three parts were before this";

  server->channel()->Expire(SteadyClock().Now());
  ASSERT_TRUE(Answers(**channel)) << "there is time";
  server->channel()->Expire(SteadyClock().Now() + std::chrono::hours(2));

  ASSERT_TRUE(EventuallyTrue([&] { return !server->reason().empty(); }));
  EXPECT_EQ(server->reason(), "desk was disconnected: it began a message and did not finish it");
}

TEST_P(LargeMessageContract, ACompleteMessageLeavesNoTimeout) {
  const auto server = std::make_shared<Choosy>();
  Connect(server, std::make_shared<ChannelHandler>());
  ASSERT_TRUE(channel_->Call(kAsk, 0, Bytes(kThreeMebibytes), kLong));

  server->channel()->Expire(SteadyClock().Now() + std::chrono::hours(2));

  EXPECT_TRUE(Answers(*channel_));
  EXPECT_THAT(server->reason(), IsEmpty());
}

TEST_P(LargeMessageContract, ADisallowedMessageIsRefusedAtItsFirstPart) {
  const auto server = std::make_shared<Choosy>();
  Connect(server, std::make_shared<ChannelHandler>());

  const auto reply = channel_->Call(kForbidden, 0, Bytes(kThreeMebibytes), kLong);
  ASSERT_EQ(channel_->Notify(kForbidden, 0, Bytes(kThreeMebibytes)), Status::kQueued);

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error(), (Error{ErrorCode::kDenied, "nobody may send it"}));
  EXPECT_TRUE(Answers(*channel_));
  EXPECT_TRUE(channel_->Call(kAsk, 0, Bytes(kThreeMebibytes), kLong))
      << "it comes behind the others";
  EXPECT_EQ(server->came(), 0);
}

TEST_P(LargeMessageContract, ALateReplyIsIgnoredAndTheChannelStaysOpen) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<ChannelHandler>());
  channel_->Request(kKeep, 0, Bytes(), std::chrono::hours(1), [](const Result<Bytes>&) {});
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.kept_.size() == 1; }));
  channel_->Expire(SteadyClock().Now() + std::chrono::hours(2));

  server->kept_.front().Reply(Bytes(kThreeMebibytes));

  const auto next = channel_->Call(kDrop, 0, Bytes(), kLong);  // it follows the late reply
  ASSERT_FALSE(next);
  EXPECT_EQ(next.error().code, ErrorCode::kFailed) << "it is refused, for the channel lives";
  EXPECT_TRUE(channel_->is_open());
}

}  // namespace
}  // namespace tendon::conformance
