#include <gtest/gtest.h>
#include <support/wait.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/loopback.h>
#include <tendon/middleware/reply_batch.h>

#include <chrono>
#include <deque>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon {
namespace {

using NumberedReply = std::pair<std::uint64_t, Bytes>;

std::vector<NumberedReply> RepliesIn(std::span<const std::byte> body) {
  std::vector<NumberedReply> all;
  while (const auto one = TakeReply(body)) {
    all.emplace_back(one->request, Bytes(one->body.begin(), one->body.end()));
  }
  return all;
}

/// Returns a batch of two replies: one of two bytes, and an empty one.
Bytes TwoReplies() {
  ReplyBatch batch;
  EXPECT_TRUE(batch.Add(7, Bytes(2, std::byte{5})));
  EXPECT_TRUE(batch.Add(std::numeric_limits<std::uint64_t>::max(), {}));
  return batch.body();
}

TEST(ReplyBatch, KeepsTheOrder) {
  const std::vector<NumberedReply> expected{{7, Bytes(2, std::byte{5})},
                                            {std::numeric_limits<std::uint64_t>::max(), {}}};

  EXPECT_EQ(RepliesIn(TwoReplies()), expected);
  EXPECT_TRUE(IsReplyBatch(TwoReplies()));
}

TEST(ReplyBatch, HasAFixedLayout) {
  const auto bytes = [](std::initializer_list<unsigned char> all) {
    Bytes result;
    for (const unsigned char one : all) result.push_back(std::byte{one});
    return result;
  };
  EXPECT_EQ(TwoReplies(), bytes({7,   0,   0,   0,   0,   0,   0,   0,  // request
                                 2,   0,   0,   0,   5,   5,            // answer
                                 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0}));
}

TEST(ReplyBatch, LimitsTheNumberOfReplies) {
  ReplyBatch batch;
  for (std::uint64_t i = 1; i <= ReplyBatch::kMaxReplies; ++i) EXPECT_TRUE(batch.Add(i, {}));

  EXPECT_FALSE(batch.Add(1000, {}));
  EXPECT_EQ(batch.replies(), ReplyBatch::kMaxReplies);
  EXPECT_TRUE(IsReplyBatch(batch.body()));
  batch.Clear();
  EXPECT_TRUE(batch.Add(1000, {}));
}

TEST(ReplyBatch, LimitsTheNumberOfBytes) {
  constexpr std::size_t kLargest = ReplyBatch::kMaxBytes - ReplyBatch::kOverhead;
  ReplyBatch batch;

  EXPECT_FALSE(batch.Add(1, Bytes(kLargest + 1)));
  EXPECT_FALSE(batch.Add(1, Bytes(2 * kLargest)));
  EXPECT_EQ(batch.replies(), 0U);
  EXPECT_TRUE(batch.Add(1, Bytes(kLargest)));
  EXPECT_FALSE(batch.Add(2, {}));
  EXPECT_TRUE(IsReplyBatch(batch.body()));
}

TEST(ReplyBatch, RefusesFalseSizes) {
  const Bytes whole = TwoReplies();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const bool ends_with_a_reply = size == ReplyBatch::kOverhead + 2;
    EXPECT_EQ(IsReplyBatch(std::span(whole).first(size)), ends_with_a_reply) << size << " bytes";
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(IsReplyBatch(longer));
  for (std::size_t i = 8; i < 12; ++i) {  // the bytes of the first reply's size
    Bytes claims_more = whole;
    claims_more[i] = std::byte{255};
    EXPECT_FALSE(IsReplyBatch(claims_more)) << "byte " << i;
  }
}

TEST(ReplyBatch, RefusesTooManyOrTooLargeReplies) {
  EXPECT_FALSE(IsReplyBatch(Bytes((ReplyBatch::kMaxReplies + 1) * ReplyBatch::kOverhead)));
  Bytes large(ReplyBatch::kMaxBytes + 1);
  const auto size = static_cast<std::uint32_t>(large.size() - ReplyBatch::kOverhead);
  for (std::size_t i = 0; i < 4; ++i) large[8 + i] = static_cast<std::byte>(size >> (8 * i));

  EXPECT_EQ(RepliesIn(large).size(), 1U);
  EXPECT_FALSE(IsReplyBatch(large));
}

constexpr std::chrono::seconds kLongEnough(120);
constexpr auto kKept = static_cast<MessageType>(0x101);

/// Stores the requests of its peers until Answer() is called.
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
  /// Answers the oldest request with this number of bytes.
  void Answer(std::size_t size = 1) {
    const std::scoped_lock lock(mutex_);
    kept_.front().Reply(Bytes(size), kOwnLane);
    kept_.pop_front();
  }

 private:
  mutable std::mutex mutex_;
  std::deque<Responder> kept_;
};

/// Two peers of one server. The replies to each peer are recorded message by message.
class ReplyBatcherTest : public testing::Test {
 protected:
  ReplyBatcherTest() {
    network_->SetFaultInjector([this](const loopback::Frame& frame) {
      const auto type = ReadFrameHeader(frame.bytes)->type;
      const std::scoped_lock lock(mutex_);
      if (type == MessageType::kReply) ++replies_;
      if (type == MessageType::kReplies) {
        replies_ += RepliesIn(std::span(frame.bytes).subspan(FrameHeader::kSize)).size();
      }
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
      channel.Request(kKept, 0, Bytes(), kLongEnough, [this](const Result<Bytes>& reply) {
        const std::scoped_lock lock(mutex_);
        if (reply) ++answered_;
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
  /// The number of replies in these messages.
  [[nodiscard]] std::size_t replies() const {
    const std::scoped_lock lock(mutex_);
    return replies_;
  }
  [[nodiscard]] std::vector<MessageType> sent() const {
    const std::scoped_lock lock(mutex_);
    return sent_;
  }

  using Types = std::vector<MessageType>;

  mutable std::mutex mutex_;
  std::size_t answered_ = 0;
  std::size_t replies_ = 0;
  Types sent_;
  const Hello hello_{.instance = 1, .name = "robot", .cookie = 7};
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const std::shared_ptr<Keeper> keeper_ = std::make_shared<Keeper>();
  LoopbackMiddleware middleware_{network_};
  std::unique_ptr<Listener> listener_;
  std::shared_ptr<Channel> one_;
  std::shared_ptr<Channel> other_;
};

TEST_F(ReplyBatcherTest, SendsRepliesInOneMessage) {
  Ask(*one_, 5);

  AnswerTogether(5);

  EXPECT_EQ(sent(), Types{MessageType::kReplies});
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 5; }));
}

TEST_F(ReplyBatcherTest, SendsASingleReplyUnbatched) {
  Ask(*one_, 1);

  AnswerTogether(1);

  EXPECT_EQ(sent(), Types{MessageType::kReply});
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 1; }));
}

TEST_F(ReplyBatcherTest, SendsNothingWithoutReplies) {
  AnswerTogether(0);

  EXPECT_EQ(sent(), Types{});
}

TEST_F(ReplyBatcherTest, EndsWithItsScope) {
  Ask(*one_, 3);
  AnswerTogether(2);

  keeper_->Answer();

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReply}));
}

TEST_F(ReplyBatcherTest, SendsAFullMessageAndContinues) {
  Ask(*one_, ReplyBatch::kMaxReplies + 1);

  AnswerTogether(ReplyBatch::kMaxReplies + 1);

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReply}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == ReplyBatch::kMaxReplies + 1; }));
  EXPECT_EQ(replies(), ReplyBatch::kMaxReplies + 1);
}

TEST_F(ReplyBatcherTest, LimitsTheBytesOfAMessage) {
  Ask(*one_, 4);

  AnswerTogether(4, ReplyBatch::kMaxBytes / 3);

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReplies}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 4; }));
}

TEST_F(ReplyBatcherTest, SendsTooLargeRepliesUnbatched) {
  Ask(*one_, 2);

  AnswerTogether(2, ReplyBatch::kMaxBytes);

  EXPECT_EQ(sent(), (Types{MessageType::kReply, MessageType::kReply}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 2; }));
}

TEST_F(ReplyBatcherTest, KeepsPeersSeparate) {
  Ask(*one_, 2);
  Ask(*other_, 2);

  AnswerTogether(4);

  EXPECT_EQ(sent(), (Types{MessageType::kReplies, MessageType::kReplies}));
  EXPECT_TRUE(EventuallyTrue([&] { return answered() == 4; }));
  EXPECT_EQ(replies(), 4U);
}

}  // namespace

}  // namespace tendon
