#include <gtest/gtest.h>
#include <tendon/gcm/members/connection_restorer.h>
#include <tests/core/gcm/samples.h>

namespace tendon::server {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using Kind = CatalogueChange::Kind;
using Verdict = ConnectionRestorer::Verdict;

const message::ConnectionEnds kEnds{{"desk", "teleoperation", "Robot"},
                                    {"robot", "arm", "Control"}};
const std::vector<message::ConnectionEnds> kNone;
const std::vector<message::ConnectionEnds> kOne = {kEnds};

/// A desk that was killed while it was connected to a robot.
class ConnectionRestorerTest : public testing::Test {
 protected:
  void SetUp() override {
    Enter("robot", test::Arm());
    Enter("desk", test::Teleoperation());
    const ConnectionDescription connection{.id = 1,
                                           .required = kEnds.required,
                                           .provided = kEnds.provided,
                                           .state = ConnectionState::kActive};
    Apply({.kind = Kind::kConnection, .process = "desk", .connections = {connection}});
    restorer_.Keep(catalogue_, "desk");
    Apply({.kind = Kind::kConnectionRemoved, .process = "desk", .connection = 1});
  }

  void Apply(CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    ASSERT_TRUE(catalogue_.Apply(change));
  }
  void Enter(const std::string& process, const ComponentDescription& component) {
    Apply({.kind = Kind::kProcess,
           .process = process,
           .processes = {test::ProcessNamed(process, 1)}});
    Apply({.kind = Kind::kComponent, .process = process, .components = {component}});
  }

  std::vector<message::ConnectionEnds> TakeDue() { return restorer_.TakeDue(catalogue_, now_); }
  Verdict Settle(const Result<void>& outcome) { return restorer_.Settle(kEnds, outcome, now_); }

  Catalogue catalogue_;
  ConnectionRestorer restorer_;
  SteadyTime now_{1h};
};

TEST_F(ConnectionRestorerTest, OrdersAConnectionOnce) {
  EXPECT_EQ(TakeDue(), kOne);
  EXPECT_EQ(TakeDue(), kNone);
}

TEST_F(ConnectionRestorerTest, ForgetsARestoredConnection) {
  ASSERT_EQ(TakeDue(), kOne);
  EXPECT_EQ(Settle({}), Verdict::kDone);

  now_ += 1h;
  EXPECT_FALSE(restorer_.IsPauseOver(now_));
  EXPECT_EQ(TakeDue(), kNone);
}

TEST_F(ConnectionRestorerTest, RetriesWithAGrowingPause) {
  auto expected = Verdict::kTryAgain;
  for (const auto pause : {200ms, 400ms, 800ms, 1600ms, 3200ms, 5000ms, 5000ms}) {
    ASSERT_EQ(TakeDue(), kOne);
    EXPECT_EQ(Settle(Error{ErrorCode::kTimeout, "no reply"}), expected);
    expected = Verdict::kStillTrying;

    now_ += pause - 1ms;
    EXPECT_FALSE(restorer_.IsPauseOver(now_));
    ASSERT_EQ(TakeDue(), kNone);
    now_ += 1ms;
    EXPECT_TRUE(restorer_.IsPauseOver(now_));
  }
}

TEST_F(ConnectionRestorerTest, ForgetsAPermanentlyRefusedConnection) {
  for (const ErrorCode code :
       {ErrorCode::kIncompatible, ErrorCode::kInvalid, ErrorCode::kDenied, ErrorCode::kExists}) {
    ConnectionRestorer fresh = restorer_;
    ASSERT_EQ(fresh.TakeDue(catalogue_, now_), kOne);
    EXPECT_EQ(fresh.Settle(kEnds, Error{code, "no"}, now_), Verdict::kGivenUp);
    EXPECT_EQ(fresh.TakeDue(catalogue_, now_ + 1h), kNone);
  }
}

TEST_F(ConnectionRestorerTest, IgnoresTheResultOfAnEarlierInstance) {
  ASSERT_EQ(TakeDue(), kOne);
  // The connection is made. Then the process is killed again before the outcome is known.
  const ConnectionDescription connection{
      .id = 2, .required = kEnds.required, .provided = kEnds.provided};
  Apply({.kind = Kind::kConnection, .process = "desk", .connections = {connection}});
  restorer_.Keep(catalogue_, "desk");
  Apply({.kind = Kind::kConnectionRemoved, .process = "desk", .connection = 2});

  EXPECT_EQ(Settle({}), Verdict::kDone);

  EXPECT_EQ(TakeDue(), kOne);
}

TEST_F(ConnectionRestorerTest, DoesNotRestoreOverAUsersNewConnection) {
  Apply({.kind = Kind::kComponentRemoved, .process = "robot", .component = "arm"});
  const ConnectionDescription other{
      .id = 2, .required = kEnds.required, .provided = {"desk", "old_arm", "Control"}};
  Apply({.kind = Kind::kConnection, .process = "desk", .connections = {other}});
  EXPECT_EQ(TakeDue(), kNone);
  Apply({.kind = Kind::kConnectionRemoved, .process = "desk", .connection = 2});
  Apply({.kind = Kind::kComponent, .process = "robot", .components = {test::Arm()}});

  EXPECT_EQ(TakeDue(), kNone);
}

}  // namespace
}  // namespace tendon::server
