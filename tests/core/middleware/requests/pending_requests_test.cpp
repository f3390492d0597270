#include <gtest/gtest.h>
#include <tendon/middleware/requests/pending_requests.h>

#include <stdexcept>
#include <vector>

namespace tendon {
namespace {

using std::chrono::hours;

/// Keeps what became of each request.
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

TEST(PendingRequests, EachHasANumberOfItsOwnThatIsNotZero) {
  PendingRequests requests;
  Outcomes outcomes;

  const auto first = Add(requests, outcomes.Keep());
  const auto second = Add(requests, outcomes.Keep());

  EXPECT_NE(first, 0U);
  EXPECT_NE(second, 0U);
  EXPECT_NE(first, second);
}

TEST(PendingRequests, TheFirstAnswerCountsAndTheOthersAreLate) {
  PendingRequests requests;
  Outcomes outcomes;
  const auto request = Add(requests, outcomes.Keep());

  requests.OnAnswer(request, Bytes(1));
  requests.OnAnswer(request, Bytes(2));
  requests.OnAnswer(12345, Bytes(3));

  ASSERT_EQ(outcomes.all.size(), 1U);
  EXPECT_EQ(*outcomes.all[0], Bytes(1));
  EXPECT_EQ(requests.late_answers(), 2U);
}

TEST(PendingRequests, ExpireEndsWhatIsDue) {
  PendingRequests requests;
  Outcomes outcomes;
  Add(requests, outcomes.Keep(), hours(1));
  Add(requests, outcomes.Keep(), hours(3));

  requests.Expire(SteadyClock().Now() + hours(2), "robot");

  ASSERT_EQ(outcomes.all.size(), 1U);
  EXPECT_EQ(
      outcomes.all[0].error(),
      (Error{ErrorCode::kTimeout, "no answer from robot within 3600000 ms; outcome unknown"}));
}

TEST(PendingRequests, FinishAllEndsAllAndTakesNoMore) {
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

TEST(PendingRequests, AHandlerMayAskAgain) {
  PendingRequests requests;
  Outcomes outcomes;
  std::uint64_t second = 0;
  const auto first = Add(
      requests, [&](const Result<Bytes>& /*outcome*/) { second = Add(requests, outcomes.Keep()); });

  requests.OnAnswer(first, Bytes());
  requests.OnAnswer(second, Bytes());

  EXPECT_EQ(outcomes.all.size(), 1U);
}

TEST(PendingRequests, WhatAHandlerThrowsStaysHere) {
  PendingRequests requests;
  const auto request =
      Add(requests, [](const Result<Bytes>& /*outcome*/) { throw std::runtime_error("oh"); });

  EXPECT_NO_THROW(requests.OnAnswer(request, Bytes()));
}

TEST(PendingRequests, AWithdrawnOneIsForgotten) {
  PendingRequests requests;
  int called = 0;
  PendingRequests::Handler handler = [&called](const Result<Bytes>& /*answer*/) { ++called; };
  const std::uint64_t request = requests.Add(std::chrono::seconds(1), handler);

  requests.Withdraw(request);

  EXPECT_FALSE(requests.Finish(request, Bytes()));
  requests.FinishAll({ErrorCode::kUnreachable, "closed"});
  EXPECT_EQ(called, 0);
}

}  // namespace
}  // namespace tendon
