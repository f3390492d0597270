#include <tendon/middleware/reply_batch.h>

#include <algorithm>
#include <future>
#include <mutex>
#include <numeric>
#include <vector>

#include "conformance/contract.h"
#include "conformance/oracle.h"

namespace tendon::conformance {
namespace {

/// Records the replies to several requests: their order, and how often each request was answered.
/// The reply to a request is the number of the request.
class Outcomes {
 public:
  PendingRequests::Handler Keep(std::uint32_t number) {
    return [this, number](const Result<Bytes>& reply) {
      const std::scoped_lock lock(mutex_);
      const bool is_right = reply && DecodeBody<std::uint32_t>(*reply).value() == number;
      (is_right ? answered_ : failed_).push_back(number);
    };
  }
  bool WaitFor(std::size_t answered, std::size_t failed) {
    return EventuallyTrue([&] {
      const std::scoped_lock lock(mutex_);
      return answered_.size() >= answered && failed_.size() >= failed;
    });
  }
  [[nodiscard]] std::vector<std::uint32_t> answered() const {
    const std::scoped_lock lock(mutex_);
    return answered_;
  }
  [[nodiscard]] std::vector<std::uint32_t> failed() const {
    const std::scoped_lock lock(mutex_);
    return failed_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::uint32_t> answered_;
  std::vector<std::uint32_t> failed_;
};

std::vector<std::uint32_t> NumbersUpTo(std::uint32_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// Sends requests that the oracle keeps. Returns when the oracle has received all of them.
void AskToKeep(Channel& channel, Oracle& oracle, Outcomes& outcomes, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    channel.Request(kKeep, 0, EncodeBody(i), kLong, outcomes.Keep(i));
  }
  ASSERT_TRUE(oracle.Wait([&](const Oracle& one) { return one.kept_.size() == count; }));
}

TEST_P(ChannelContract, BatchedRepliesArriveOnceAndInOrder) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  constexpr std::uint32_t kCount = 2 * ReplyBatch::kMaxReplies + 44;
  Outcomes outcomes;
  ASSERT_NO_FATAL_FAILURE(AskToKeep(*channel_, *server, outcomes, kCount));

  {
    const ReplyBatcher together;
    for (std::uint32_t i = 0; i < kCount; ++i) server->kept_[i].Reply(EncodeBody(i), kOwnLane);
  }

  EXPECT_TRUE(outcomes.WaitFor(kCount, 0));
  EXPECT_EQ(outcomes.answered(), NumbersUpTo(kCount));
}

TEST_P(ChannelContract, ALargeReplyInABatchArrives) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  Outcomes outcomes;
  ASSERT_NO_FATAL_FAILURE(AskToKeep(*channel_, *server, outcomes, 1));
  auto large = std::async(std::launch::async, [&] { return channel_->Call(kKeep, 0, {}, kLong); });
  ASSERT_TRUE(server->Wait([](const Oracle& one) { return one.kept_.size() == 2; }));

  {
    const ReplyBatcher together;
    server->kept_[0].Reply(EncodeBody(std::uint32_t{0}), kOwnLane);
    server->kept_[1].Reply(Bytes(3 * kMaxPieceSize, std::byte{7}), kOwnLane);
  }

  EXPECT_TRUE(outcomes.WaitFor(1, 0));
  const auto reply = large.get();
  ASSERT_TRUE(reply.ok()) << reply.error().message;
  EXPECT_TRUE(std::ranges::equal(reply->body(), Bytes(3 * kMaxPieceSize, std::byte{7})));
}

TEST_P(ChannelContract, ALostReplyBatchFailsAllItsRequests) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  Outcomes outcomes;
  ASSERT_NO_FATAL_FAILURE(AskToKeep(*channel_, *server, outcomes, 8));

  {
    const ReplyBatcher together;
    for (std::uint32_t i = 0; i < 8; ++i) server->kept_[i].Reply(EncodeBody(i), kOwnLane);
    channel_->Close();
    ASSERT_TRUE(server->Wait([](const Oracle& one) { return one.closed_.size() == 1; }));
  }

  EXPECT_TRUE(outcomes.WaitFor(0, 8));
  EXPECT_EQ(outcomes.failed(), NumbersUpTo(8));
  EXPECT_TRUE(outcomes.answered().empty());
}

TEST_P(ChannelContract, AMalformedReplyBatchClosesTheChannel) {
  const auto server = std::make_shared<Oracle>();
  const auto client = std::make_shared<Oracle>();
  Connect(server, client);
  Outcomes outcomes;
  ASSERT_NO_FATAL_FAILURE(AskToKeep(*channel_, *server, outcomes, 1));
  ReplyBatch batch;
  ASSERT_TRUE(batch.Add(1, EncodeBody(std::uint32_t{0})));  // the number of the first request
  Bytes lie = batch.body();
  lie.push_back(std::byte{1});

  ASSERT_TRUE(server->channel_->Notify(MessageType::kReplies, 0, lie));

  ASSERT_TRUE(client->Wait([](const Oracle& one) { return one.closed_.size() == 1; }));
  EXPECT_EQ(client->closed_.front(), (Error{ErrorCode::kInvalid, "robot sent malformed replies"}));
  EXPECT_TRUE(outcomes.WaitFor(0, 1));
  EXPECT_TRUE(outcomes.answered().empty());
}

}  // namespace
}  // namespace tendon::conformance
