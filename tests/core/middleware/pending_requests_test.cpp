#include <gtest/gtest.h>
#include <tendon/middleware/pending_requests.h>

#include <algorithm>
#include <future>
#include <set>
#include <stdexcept>
#include <vector>

namespace tendon {
namespace {

using std::chrono::hours;

/// Records the outcome of each request.
struct Outcomes {
  PendingRequests::Handler Keep() {
    return [this](Result<Bytes> outcome) { all.push_back(std::move(outcome)); };
  }
  std::vector<Result<Bytes>> all;
};

std::uint64_t Add(PendingRequests& requests, PendingRequests::Handler handler,
                  std::chrono::milliseconds timeout = hours(1)) {
  return requests.Add(timeout, handler);
}

TEST(PendingRequests, EachHasAUniqueNonZeroNumber) {
  PendingRequests requests;
  Outcomes outcomes;

  const auto first = Add(requests, outcomes.Keep());
  const auto second = Add(requests, outcomes.Keep());

  EXPECT_NE(first, 0U);
  EXPECT_NE(second, 0U);
  EXPECT_NE(first, second);
}

TEST(PendingRequests, IgnoresFurtherReplies) {
  PendingRequests requests;
  Outcomes outcomes;
  const auto request = Add(requests, outcomes.Keep());

  EXPECT_TRUE(requests.Finish(request, Reply(Bytes(1))));
  EXPECT_FALSE(requests.Finish(request, Reply(Bytes(2))));
  EXPECT_FALSE(requests.Finish(12345, Reply(Bytes(3))));

  ASSERT_EQ(outcomes.all.size(), 1U);
  EXPECT_EQ(*outcomes.all[0], Bytes(1));
}

TEST(PendingRequests, ExpireEndsDueRequests) {
  PendingRequests requests;
  Outcomes outcomes;
  Add(requests, outcomes.Keep(), hours(1));
  Add(requests, outcomes.Keep(), hours(3));

  requests.Expire(SteadyClock().Now() + hours(2), "robot");

  ASSERT_EQ(outcomes.all.size(), 1U);
  EXPECT_EQ(outcomes.all[0].error(),
            (Error{ErrorCode::kTimeout, "no reply from robot within 3600000 ms; outcome unknown"}));
}

TEST(PendingRequests, FinishAllEndsAllAndRefusesNewOnes) {
  PendingRequests requests;
  Outcomes outcomes;
  Add(requests, outcomes.Keep());
  Add(requests, outcomes.Keep());
  const Error reason{ErrorCode::kUnreachable, "gone"};

  requests.FinishAll(reason);
  auto handler = outcomes.Keep();
  const auto late = requests.Add(hours(1), handler);

  ASSERT_EQ(outcomes.all.size(), 2U);
  EXPECT_EQ(outcomes.all[0].error(), reason);
  EXPECT_EQ(late, 0U);
  EXPECT_TRUE(handler) << "the caller still has it";
}

TEST(PendingRequests, AHandlerMaySendAnotherRequest) {
  PendingRequests requests;
  Outcomes outcomes;
  std::uint64_t second = 0;
  const auto first = Add(
      requests, [&](const Result<Bytes>& /*outcome*/) { second = Add(requests, outcomes.Keep()); });

  requests.Finish(first, Reply(Bytes()));
  requests.Finish(second, Reply(Bytes()));

  EXPECT_EQ(outcomes.all.size(), 1U);
}

TEST(PendingRequests, ContainsExceptionsOfHandlers) {
  PendingRequests requests;
  const auto request =
      Add(requests, [](const Result<Bytes>& /*outcome*/) { throw std::runtime_error("oh"); });

  EXPECT_NO_THROW(requests.Finish(request, Reply(Bytes())));
}

TEST(PendingRequests, ForgetsAWithdrawnRequest) {
  PendingRequests requests;
  int called = 0;
  PendingRequests::Handler handler = [&called](const Result<Bytes>& /*answer*/) { ++called; };
  const std::uint64_t request = requests.Add(std::chrono::seconds(1), handler);

  requests.Withdraw(request);

  EXPECT_FALSE(requests.Finish(request, Reply(Bytes())));
  requests.FinishAll({ErrorCode::kUnreachable, "closed"});
  EXPECT_EQ(called, 0);
}

TEST(PendingRequests, ALongPendingRequestKeepsItsNumber) {
  PendingRequests requests;
  Outcomes outcomes;
  std::set<std::uint64_t> numbers{Add(requests, outcomes.Keep())};
  const std::uint64_t patient = *numbers.begin();

  for (int i = 0; i < 1000; ++i) {
    const auto request = Add(requests, [](const Result<Bytes>& /*outcome*/) {});
    EXPECT_TRUE(numbers.insert(request).second) << "twice the number " << request;
    EXPECT_TRUE(requests.Finish(request, Reply(Bytes())));
  }
  EXPECT_TRUE(requests.Finish(patient, Reply(Bytes(5))));

  ASSERT_EQ(outcomes.all.size(), 1U);
  EXPECT_EQ(*outcomes.all[0], Bytes(5));
}

TEST(PendingRequests, FinishAllKeepsTheOrderOfMany) {
  PendingRequests requests;
  std::vector<int> ended;
  for (int i = 0; i < 100; ++i) {
    Add(requests, [&ended, i](const Result<Bytes>& /*outcome*/) { ended.push_back(i); });
  }

  requests.FinishAll({ErrorCode::kUnreachable, "gone"});

  ASSERT_EQ(ended.size(), 100U);
  EXPECT_TRUE(std::is_sorted(ended.begin(), ended.end()));
}

TEST(BlockingRequest, ReturnsTheReply) {
  PendingRequests requests;
  BlockingRequest answer(requests);
  const auto peer =
      std::async(std::launch::async, [&] { requests.Finish(answer.number(), Reply(Bytes(3))); });

  const auto outcome = answer.WaitUntil(SteadyClock().Now() + hours(1));

  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ((*outcome)->body().size(), 3U);
}

TEST(BlockingRequest, ReturnsALentReplyWithoutACopy) {
  PendingRequests requests;
  BlockingRequest answer(requests);
  auto lent = std::make_shared<Bytes>(100'000, std::byte{7});
  const std::weak_ptr<Bytes> still = lent;
  const std::byte* const place = lent->data();
  const std::span<const std::byte> body = *lent;

  requests.Finish(answer.number(), Reply(body, std::move(lent)));

  auto outcome = answer.WaitUntil(SteadyClock().Now() + hours(1));
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ((*outcome)->body().data(), place);
  EXPECT_EQ((*outcome)->body().size(), body.size());
  outcome.reset();
  EXPECT_TRUE(still.expired());
}

TEST(PendingRequests, AHandlerGetsACopyOfALentReply) {
  PendingRequests requests;
  Bytes heard;
  PendingRequests::Handler handler = [&heard](Result<Bytes> answer) { heard = *std::move(answer); };
  const std::uint64_t number = requests.Add(std::chrono::seconds(60), handler);
  auto lent = std::make_shared<Bytes>(100, std::byte{7});
  const std::span<const std::byte> body = *lent;

  requests.Finish(number, Reply(body, std::move(lent)));

  EXPECT_EQ(heard, Bytes(100, std::byte{7}));
}

TEST(BlockingRequest, IgnoresAReplyAfterTheDeadline) {
  PendingRequests requests;
  BlockingRequest answer(requests);

  EXPECT_FALSE(answer.WaitUntil(SteadyClock().Now()).has_value());

  EXPECT_FALSE(requests.Finish(answer.number(), Reply(Bytes(3))));
}

TEST(BlockingRequest, IgnoresAReplyWithoutAWait) {
  PendingRequests requests;
  std::uint64_t number = 0;
  {
    const BlockingRequest answer(requests);
    number = answer.number();
  }

  EXPECT_FALSE(requests.Finish(number, Reply(Bytes(3))));
}

TEST(BlockingRequest, IgnoresTheReplyToAnEarlierRequest) {
  PendingRequests requests;
  std::uint64_t first = 0;
  {
    BlockingRequest answer(requests);
    first = answer.number();
    (void)answer.WaitUntil(SteadyClock().Now());
  }
  BlockingRequest next(requests);

  requests.Finish(first, Reply(Bytes(1)));
  requests.Finish(next.number(), Reply(Bytes(2)));

  const auto outcome = next.WaitUntil(SteadyClock().Now() + hours(1));
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ((*outcome)->body().size(), 2U);
}

TEST(BlockingRequest, FinishAllEndsItAndRefusesNewOnes) {
  PendingRequests requests;
  const Error reason{ErrorCode::kUnreachable, "gone"};
  BlockingRequest answer(requests);
  const auto end = std::async(std::launch::async, [&] { requests.FinishAll(reason); });

  const auto outcome = answer.WaitUntil(SteadyClock().Now() + hours(1));

  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->error(), reason);
  end.wait();
  EXPECT_EQ(BlockingRequest(requests).number(), 0U);
}

}  // namespace
}  // namespace tendon
