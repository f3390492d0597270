#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Tests `gcm undo` when the newest step cannot be undone.
class UndoSkipTest : public DemoFixture {};

TEST_F(UndoSkipTest, EachSkipSkipsOneStep) {
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);
  ASSERT_EQ(Gcm({"disconnect", "desk/teleoperation/Robot"}).exit_code, program::kOk);
  desk->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\tlost"));
  desk = StartLcm("desk", demo);
  ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));

  const Outcome dry = Gcm({"undo", "--skip", "--dry-run"});
  EXPECT_EQ(dry.exit_code, program::kRefused);
  EXPECT_EQ(dry.out, "");
  EXPECT_THAT(dry.err, HasSubstr("gcm: would be skipped and not undone: step 3 ("));
  EXPECT_THAT(dry.err, HasSubstr("gcm: cannot undo step 2 ("));
  const Outcome skipped = Gcm({"undo", "--skip"});

  EXPECT_EQ(skipped.exit_code, program::kRefused);
  EXPECT_THAT(skipped.err, HasSubstr("gcm: skipped and not undone: step 3 ("));
  EXPECT_THAT(skipped.err, HasSubstr("gcm: cannot undo step 2 ("));
  EXPECT_THAT(skipped.err, testing::Not(HasSubstr("not undone: step 2")));
  const json steps = json::parse(Gcm({"history", "--json"}).out)["steps"];
  EXPECT_EQ(steps[2]["passed_over"], true);
  EXPECT_EQ(steps[1]["passed_over"], false);
  EXPECT_EQ(steps[0]["passed_over"], false);
}

TEST_F(UndoSkipTest, ADryRunListsSkippedAndUndoneSteps) {
  ASSERT_EQ(Gcm({"stop", "robot/host_monitor"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"disconnect", "desk/supervisor/Robot"}).exit_code, program::kOk);
  desk->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\tlost"));
  const Outcome waits = Gcm({"undo", "--skip", "--dry-run"});
  EXPECT_EQ(waits.exit_code, program::kRefused);
  EXPECT_THAT(waits.err, HasSubstr("try again when the process is back"));
  desk = StartLcm("desk", demo);
  ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));

  const Outcome dry = Gcm({"undo", "--skip", "--dry-run"});

  EXPECT_EQ(dry.exit_code, program::kOk) << dry.err;
  EXPECT_EQ(dry.out, "would be undone: stop robot/host_monitor\n");
  EXPECT_THAT(dry.err, HasSubstr("would be skipped and not undone: step 2 (disconnect"));
  EXPECT_EQ(Gcm({"undo", "--skip"}).out, "undone: stop robot/host_monitor\n");
}

}  // namespace
