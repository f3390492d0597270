#include <gmock/gmock.h>

#include <future>

#include "conformance/contract.h"
#include "conformance/oracle.h"

namespace tendon::conformance {
namespace {

using testing::HasSubstr;

TEST_P(ChannelContract, BothEndsLearnThePeersIdentity) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());

  EXPECT_EQ(channel_->peer().name, "robot");
  EXPECT_EQ(channel_->peer().instance, 5U);
  EXPECT_TRUE(channel_->is_open());
  EXPECT_EQ(channel_->peer_address(), listener_->address());
  EXPECT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.peer_ == "desk"; }));
}

TEST_P(ChannelContract, ARequestIsAnswered) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());

  const auto reply = channel_->Call<Question>(kAsk, 42, Question{"why", 0}, kLong);

  ASSERT_TRUE(reply) << reply.error().message;
  EXPECT_EQ(reply->text, "whywhy");
  EXPECT_EQ(reply->number, 42);
}

TEST_P(ChannelContract, BothEndsMaySendRequests) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.channel_ != nullptr; }));

  const auto reply = server->channel_->Call<Question>(kAsk, 1, Question{"who", 0}, kLong);

  ASSERT_TRUE(reply) << reply.error().message;
  EXPECT_EQ(reply->text, "whowho");
}

TEST_P(ChannelContract, ManyRequestsAtOnceAreEachAnsweredOnce) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());
  constexpr int kCount = 1000;
  std::mutex mutex;
  std::vector<int> answers(kCount);

  for (int i = 0; i < kCount; ++i) {
    channel_->Request<Question>(kAsk, static_cast<std::uint32_t>(i), Question{"x", 0}, kLong,
                                [&, i](Result<Question> reply) {
                                  const std::scoped_lock lock(mutex);
                                  if (reply && reply->number == i) ++answers[i];
                                });
  }

  EXPECT_TRUE(EventuallyTrue([&] {
    const std::scoped_lock lock(mutex);
    return answers == std::vector<int>(kCount, 1);
  }));
}

TEST_P(ChannelContract, NoticesArriveInOrder) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  std::vector<std::string> expected;

  for (int i = 0; i < 1000; ++i) {
    expected.push_back(std::to_string(i));
    ASSERT_EQ(channel_->Notify(kTell, 0, Question{expected.back(), 0}), Status::kQueued);
  }

  ASSERT_TRUE(server->Wait([&](const Oracle& oracle) { return oracle.told_.size() == 1000; }));
  EXPECT_EQ(server->told_, expected);
}

TEST_P(ChannelContract, ARefusalKeepsItsCodeAndMessage) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());

  const auto reply = channel_->Call<Question>(kAsk, 0, Question{}, kLong);

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error(), (Error{ErrorCode::kNotFound, "there is no question"}));
}

TEST_P(ChannelContract, AnUnknownMessageIsRefused) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());

  const auto reply = channel_->Call<None>(static_cast<MessageType>(999), 0, None{}, kLong);

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(reply.error().message, HasSubstr("999"));
}

TEST_P(ChannelContract, RefusesAnUndecodableBodyNamingItsType) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());

  const auto reply = channel_->Call(kAsk, 0, Bytes(3), kLong);

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(reply.error().message, HasSubstr("test.Question"));
}

TEST_P(ChannelContract, AThrowingHandlerRefusesAndTheChannelStaysOpen) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());

  const auto failed = channel_->Call<None>(kThrow, 0, None{}, kLong);
  (void)channel_->Notify(kThrow, 0, None{});
  const auto dropped = channel_->Call<None>(kDrop, 0, None{}, kLong);

  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kFailed);
  EXPECT_FALSE(dropped);
  EXPECT_TRUE(channel_->Call<Question>(kAsk, 0, Question{"still there?", 0}, kLong));
}

TEST_P(ChannelContract, ACallTimesOutAndItsLateReplyIsIgnored) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());

  const auto reply = channel_->Call<None>(kKeep, 0, None{}, std::chrono::milliseconds(30));

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::kTimeout);
  EXPECT_EQ(reply.error().message, "no reply from robot within 30 ms; outcome unknown");
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.kept_.size() == 1; }));
  server->kept_.front().ReplyWith(Result<void>());
  EXPECT_TRUE(channel_->Call<Question>(kAsk, 0, Question{"still there?", 0}, kLong));
}

TEST_P(ChannelContract, ExpireEndsOnlyTheRequestsThatAreDue) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  std::promise<Result<Bytes>> first;
  std::promise<Result<Bytes>> second;
  channel_->Request(kKeep, 0, Bytes(), std::chrono::hours(1),
                    [&](Result<Bytes> reply) { first.set_value(std::move(reply)); });
  channel_->Request(kKeep, 0, Bytes(), std::chrono::hours(3),
                    [&](Result<Bytes> reply) { second.set_value(std::move(reply)); });
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.kept_.size() == 2; }));

  channel_->Expire(SteadyClock().Now() + std::chrono::hours(2));

  const auto expired = first.get_future().get();
  ASSERT_FALSE(expired);
  EXPECT_EQ(expired.error().code, ErrorCode::kTimeout);
  for (auto& responder : server->kept_) responder.ReplyWith(Result<void>());
  EXPECT_TRUE(second.get_future().get());  // it follows the late reply to the first request
}

TEST_P(ChannelContract, AReplyMayComeLaterFromAnotherThread) {
  const auto server = std::make_shared<Oracle>();
  Connect(server, std::make_shared<Oracle>());
  auto reply =
      std::async(std::launch::async, [&] { return channel_->Call<None>(kKeep, 0, None{}, kLong); });
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.kept_.size() == 1; }));

  server->kept_.front().ReplyWith(Result<void>());
  server->kept_.front().Refuse(Error{});

  EXPECT_TRUE(reply.get());
}

TEST_P(ChannelContract, ClosingEndsPendingRequests) {
  const auto server = std::make_shared<Oracle>();
  const auto client = std::make_shared<Oracle>();
  Connect(server, client);
  auto reply =
      std::async(std::launch::async, [&] { return channel_->Call<None>(kKeep, 0, None{}, kLong); });
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return oracle.kept_.size() == 1; }));

  server->channel_->Close();

  const auto outcome = reply.get();
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().code, ErrorCode::kUnreachable);
  ASSERT_TRUE(client->Wait([](const Oracle& oracle) { return !oracle.closed_.empty(); }));
  ASSERT_TRUE(server->Wait([](const Oracle& oracle) { return !oracle.closed_.empty(); }));
  EXPECT_FALSE(channel_->is_open());
  EXPECT_EQ(channel_->Notify(kTell, 0, None{}), Status::kNotConnected);
  EXPECT_EQ(channel_->Call<None>(kAsk, 0, None{}, kLong).error().code, ErrorCode::kUnreachable);
}

TEST_P(ChannelContract, ReleasesTheHandlerAfterClosing) {
  auto client = std::make_shared<Oracle>();
  Connect(std::make_shared<Oracle>(), client);
  client->channel_.reset();

  channel_->Close();

  EXPECT_TRUE(EventuallyTrue([&] { return client.use_count() == 1; }));
  EXPECT_TRUE(client->Wait([](const Oracle& oracle) { return oracle.closed_.size() == 1; }));
}

TEST_P(ChannelContract, RefusesACallFromAHandlerThatWouldDeadlock) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());
  std::promise<Result<None>> inner;

  channel_->Request<Question>(kAsk, 0, Question{"x", 0}, kLong, [&](Result<Question> /*reply*/) {
    inner.set_value(channel_->Call<None>(kAsk, 0, None{}, kLong));
  });

  const auto refused = inner.get_future().get();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "a call to robot would wait for its own thread");
}

TEST_P(ChannelContract, RefusesAMessageOverTheLimitAndStaysOpen) {
  Connect(std::make_shared<Oracle>(), std::make_shared<Oracle>());

  const auto reply = channel_->Call(kAsk, 0, Bytes(kMaxBodySize + 1), kLong);

  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error().code, ErrorCode::kInvalid);
  EXPECT_THAT(reply.error().message, HasSubstr("67 108 864 B"));
  EXPECT_TRUE(channel_->Call<Question>(kAsk, 0, Question{"still there?", 0}, kLong));
}

}  // namespace
}  // namespace tendon::conformance
