#include <gtest/gtest.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/loopback.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

namespace tendon {
namespace {

constexpr std::chrono::seconds kVeryLong(60);
constexpr auto kOfSoManyBytes = static_cast<MessageType>(0x101);

/// Answers at once. The request contains the number of bytes of the reply.
class Filler final : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> body, Responder responder) override {
    Bytes answer(*DecodeBody<std::uint32_t>(body), std::byte{7});
    responder.Reply(answer, kOwnLane);
  }
};

/// Replies that return on the path of their request, from a server to a client.
class DirectReplies : public testing::Test {
 protected:
  DirectReplies() {
    network_->SetFaultInjector([this](const loopback::Frame& frame) {
      const auto header = ReadFrameHeader(frame.bytes);
      const std::scoped_lock lock(mutex_);
      if (header->size >= kMinPartSize) large_.insert(header->type);
      return loopback::kPass;
    });
    auto listener = server_.Listen(
        "127.0.0.1:0", Channel::Acceptor(hello_, [] { return std::make_shared<Filler>(); }));
    EXPECT_TRUE(listener.ok());
    listener_ = *std::move(listener);
  }

  std::shared_ptr<Channel> Open() {
    return *Channel::Open(client_, listener_->address(), hello_, std::make_shared<ChannelHandler>(),
                          kVeryLong);
  }
  /// Returns the types of the messages in which a reply has arrived.
  std::set<MessageType> WayOf(Channel& channel, std::size_t size) {
    {
      const std::scoped_lock lock(mutex_);
      large_.clear();
    }
    const auto answer = channel.Call(
        kOfSoManyBytes, 0, std::span<const std::byte>(EncodeBody(static_cast<std::uint32_t>(size))),
        kVeryLong, kOwnLane, Delivery::kDirect);
    EXPECT_TRUE(answer && std::ranges::equal(answer->body(), Bytes(size, std::byte{7})));
    const std::scoped_lock lock(mutex_);
    return large_;
  }
  /// Returns true if a reply returns directly at least once. The result of a measurement of the
  /// line is used for a second, so on a slow machine several tries are needed.
  bool IsOnceReturned(Channel& channel, std::size_t size) {
    for (int i = 0; i < 20; ++i) {
      if (WayOf(channel, size) == Ways{MessageType::kReply}) return true;
    }
    return false;
  }

  using Ways = std::set<MessageType>;
  static constexpr std::size_t kLargest = kMaxReturned - FrameHeader::kSize;

  std::mutex mutex_;
  Ways large_;
  const Hello hello_{.instance = 1, .name = "robot", .cookie = 7};
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server_{network_};
  LoopbackMiddleware client_{network_};
  std::unique_ptr<Listener> listener_;
};

TEST_F(DirectReplies, AreSentWholeOnAFastLink) {
  const auto channel = Open();

  EXPECT_EQ(WayOf(*channel, kLargest), Ways{MessageType::kPart});
  EXPECT_TRUE(IsOnceReturned(*channel, kLargest));
}

TEST_F(DirectReplies, AreSentInPartsIfTooLarge) {
  const auto channel = Open();

  EXPECT_FALSE(IsOnceReturned(*channel, kLargest + 1));
}

}  // namespace
}  // namespace tendon
