#include <gmock/gmock.h>
#include <tendon/gcm/system/client_executor.h>
#include <tests/core/gcm/gcm_fixture.h>

namespace tendon {
namespace {

using test::kControl;
using test::kRobot;
using testing::HasSubstr;

class PlanLock : public test::DeskAndRobot {
 protected:
  void SetUp() override {
    DeskAndRobot::SetUp();
    other_ = Watch(nullptr, "anna@desk");
  }
  static Result<void> Take(GcmClient& client) {
    return Wait<void>(kLong, [&](auto handler) { client.TakePlanLock(handler); });
  }
  static PlanOutcome CarryOut(GcmClient& client) {
    ClientExecutor executor(client, kLong);
    return ExecutePlan({.steps = {{.kind = PlanStep::Kind::kConnect, .ends = {kRobot, kControl}}}},
                       executor, AfterError::kStop, [](auto&&...) {});
  }

  std::unique_ptr<GcmClient> other_;
};

INSTANTIATE_TEST_SUITE_P(Over, PlanLock, testing::Values("loopback", "tcp"), test::NameOfParameter);

TEST_P(PlanLock, RefusesASecondPlanWithoutExecutingAnyStep) {
  ASSERT_TRUE(Take(*other_));

  const PlanOutcome outcome = CarryOut(*client_);

  EXPECT_EQ(outcome.done, 0U);
  EXPECT_EQ(outcome.left, 1U);
  ASSERT_TRUE(outcome.error);
  EXPECT_EQ(outcome.error->code, ErrorCode::kFailed);
  EXPECT_THAT(outcome.error->message,
              HasSubstr("nothing was done, because a plan of anna@desk has been running since "));
  EXPECT_EQ(Connection(), std::nullopt);
  EXPECT_TRUE(Take(*other_)) << "it has its turn already";
}

TEST_P(PlanLock, LosingItToAnotherClientEndsThePlan) {
  ClientExecutor executor(*client_, kLong);
  ASSERT_TRUE(executor.Begin());
  client_->ReleasePlanLock();  // the end of the link does the same
  ASSERT_TRUE(EventuallyTrue([&] { return static_cast<bool>(Take(*other_)); }));
  const PlanStep connect{.kind = PlanStep::Kind::kConnect, .ends = {kRobot, kControl}};

  const auto refused = executor.Execute(connect);

  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("the plan lost its lock when the connection to "
                                                 "the GCM broke; nothing was done, because a "
                                                 "plan of anna@desk"));
  EXPECT_EQ(Connection(), std::nullopt);

  other_->ReleasePlanLock();
  EXPECT_TRUE(EventuallyTrue([&] { return static_cast<bool>(executor.Execute(connect)); }));
}

TEST_P(PlanLock, IsReleasedAtTheEndOfThePlan) {
  EXPECT_EQ(CarryOut(*other_).done, 1U);
  ASSERT_TRUE(Disconnect(*other_));

  EXPECT_EQ(CarryOut(*client_).done, 1U);
  EXPECT_NE(Connection(), std::nullopt);
}

TEST_P(PlanLock, ADeniedLockLetsThePlanFailByItself) {
  GcmClient viewer(
      NewMiddleware(),
      {.name = "viewer", .address = address_, .timeout = kLong, .role = Role::kViewer});
  ASSERT_TRUE(viewer.WaitUntilWatching());

  const PlanOutcome outcome = CarryOut(viewer);

  EXPECT_EQ(outcome.failed, 1U);
  ASSERT_TRUE(outcome.error);
  EXPECT_EQ(outcome.error->code, ErrorCode::kDenied);
}

TEST_P(PlanLock, IsReleasedWhenItsHoldersLinkEnds) {
  ASSERT_TRUE(Take(*other_));
  other_.reset();

  EXPECT_TRUE(EventuallyTrue([&] { return static_cast<bool>(Take(*client_)); }));
}

}  // namespace
}  // namespace tendon
