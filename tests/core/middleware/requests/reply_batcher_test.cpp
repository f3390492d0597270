#include <gtest/gtest.h>
#include <support/wait.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/loopback.h>
#include <tendon/middleware/requests/reply_batcher.h>

#include <chrono>
#include <deque>
#include <mutex>
#include <vector>

namespace tendon {
namespace {

constexpr std::chrono::seconds kLongEnough(20);
constexpr auto kKept = static_cast<MessageType>(0x101);

/// Keeps the requests of its peers until it is told to answer.
class Keeper final : public ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> /*body*/, Responder responder) override {
    const std::scoped_lock lock(mutex_);
    kept_.push_back(std::move(responder));
  }
  [[nodiscard]] std::size_t kept() const {
    const std::scoped_lock lock(mutex_);
    return kept_.size();
  }
  /// The oldest, which is answered with so many bytes.
  void Answer(std::size_t size = 1) {
    const std::scoped_lock lock(mutex_);
    kept_.front().Reply(Bytes(size), kOwnLane);
    kept_.pop_front();
  }

 private:
  mutable std::mutex mutex_;
  std::deque<Responder> kept_;
};

/// Two peers of one server, and the answers that go to them, message by message.
class Gathering : public testing::Test {
 protected:
  Gathering() {
    network_->SetJudge([this](const loopback::Frame& frame) {
      const auto type = ReadFrameHeader(frame.bytes)->type;
      const std::scoped_lock lock(mutex_);
      if (type == MessageType::kReply || type == MessageType::kReplies) sent_.push_back(type);
      return loopback::kPass;
    });
    auto listener =
        middleware_.Listen("127.0.0.1:0", Channel::Acceptor(hello_, [this] { return keeper_; }));
    EXPECT_TRUE(listener.ok());
    listener_ = *std::move(listener);
    for (auto* channel : {&one_, &other_}) {
      *channel = *Channel::Open(middleware_, listener_->address(), hello_,
                                std::make_shared<ChannelHandler>(), kLongEnough);
    }
  }

  void Ask(Channel& channel, std::size_t count) {
    const std::size_t before = keeper_->kept();
    for (std::size_t i = 0; i < count; ++i) {
      channel.Request(kKept, 0, Bytes(), kLongEnough, [this](const Result<Bytes>& answer) {
        const std::scoped_lock lock(mutex_);
        if (answer) ++answered_;
      });
    }
    ASSERT_TRUE(EventuallyTrue([&] { return keeper_->kept() == before + count; }));
  }
  void AnswerTogether(std::size_t count, std::size_t size = 1) {
    const ReplyBatcher together;
    for (std::size_t i = 0; i < count; ++i) keeper_->Answer(size);
  }
  [[nodiscard]] std::size_t answered() const {
    const std::scoped_lock lock(mutex_);
    return answered_;
  }
  [[nodiscard]] std::vector<MessageType> sent() const {
    const std::scoped_lock lock(mutex_);
    return sent_;
  }

  using Types = std::vector<MessageType>;

  mutable std::mutex mutex_;
  std::size_t answered_ = 0;
  Types sent_;
  const Hello hello_{.instance = 1, .name = "robot", .cookie = 7};
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const std::shared_ptr<Keeper> keeper_ = std::make_shared<Keeper>();
  LoopbackMiddleware middleware_{network_};
  std::unique_ptr<Listener> listener_;
  std::shared_ptr<Channel> one_;
  std::shared_ptr<Channel> other_;
};

TEST_F(Gathering, SendsWhatWasAnsweredInOneMessage) {
  Ask(*one_, 5);

  AnswerTogether(5);

  EXPECT_EQ(sent(), Types{MessageType::kReplies});
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 5; }));
}

TEST_F(Gathering, SendsOneAnswerAlone) {
  Ask(*one_, 1);

  AnswerTogether(1);

  EXPECT_EQ(sent(), Types{MessageType::kReply});
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 1; }));
}

TEST_F(Gathering, OfNoneSendsNothing) {
  AnswerTogether(0);

  EXPECT_EQ(sent(), Types{});
}

TEST_F(Gathering, IsOverWhereItEnds) {
  Ask(*one_, 3);
  AnswerTogether(2);

  keeper_->Answer();

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReply}));
}

TEST_F(Gathering, SendsAFullMessageAndGoesOn) {
  Ask(*one_, ReplyBatch::kMostReplies + 1);

  AnswerTogether(ReplyBatch::kMostReplies + 1);

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReply}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == ReplyBatch::kMostReplies + 1; }));
}

TEST_F(Gathering, KeepsNoMoreBytesThanAMessageHas) {
  Ask(*one_, 4);

  AnswerTogether(4, ReplyBatch::kMostBytes / 3);

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReplies}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 4; }));
}

TEST_F(Gathering, SendsWhatIsTooLargeForItByItself) {
  Ask(*one_, 2);

  AnswerTogether(2, ReplyBatch::kMostBytes);

  EXPECT_EQ(sent(), (Types{MessageType::kReply, MessageType::kReply}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 2; }));
}

TEST_F(Gathering, MixesNoTwoPeers) {
  Ask(*one_, 2);
  Ask(*other_, 2);

  AnswerTogether(4);

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReplies}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 4; }));
  EXPECT_EQ(one_->late_replies() + other_->late_replies(), 0U);
}

}  // namespace
}  // namespace tendon
