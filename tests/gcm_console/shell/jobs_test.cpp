#include <gcm_console/shell/jobs.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <ostream>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using testing::HasSubstr;

TEST(JobLines, AreWholeLinesAndCountDroppedOnes) {
  console::JobLines lines;
  console::JobStream buffer(lines);
  std::ostream out(&buffer);
  out << "one\ntwo\nthr";
  EXPECT_EQ(lines.Take(), "one\ntwo\n");

  out << "ee\n";
  for (std::size_t i = 0; i <= console::JobLines::kMax; ++i) out << i << '\n';

  const std::string all = lines.Take();
  EXPECT_THAT(all, testing::StartsWith("three\n0\n1\n"));
  EXPECT_THAT(all, testing::EndsWith(
                       "\n998\ngcm: 2 lines are omitted: the buffer for their output is full\n"));
  EXPECT_EQ(lines.Take(), "");
}

/// A user runs commands in the background of the shell.
class JobsTest : public DemoFixture {
 protected:
  void SetUp() override {
    DemoFixture::SetUp();
    shell = std::make_unique<Terminal>(
        Command(),
        std::map<std::string, std::string>{{"XDG_STATE_HOME", home.path().string()},
                                           {"HOME", home.path().string()}},
        kWide);
    ASSERT_TRUE(shell->Shows("gcm> "));
  }
  std::string Command() const {
    return Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " shell";
  }

  static constexpr unsigned short kWide = 200;
  static constexpr const char* kWatch = "watch robot/arm/state.Joints.position[0] --hz 20";
  std::unique_ptr<Terminal> shell;
};

TEST_F(JobsTest, OutputAppearsAboveTheTypedLine) {
  shell->Type(std::string(kWatch) + " &\r");
  ASSERT_TRUE(shell->Shows("gcm: in the background: 1  " + std::string(kWatch))) << shell->seen();
  ASSERT_TRUE(shell->Shows("\t0\r\n")) << shell->seen();

  shell->Type("vers");
  EXPECT_TRUE(shell->Shows("\t0\r\ngcm> vers")) << shell->seen();
  shell->Type("ion\r");
  EXPECT_TRUE(shell->Shows("protocol")) << shell->seen();
  EXPECT_TRUE(shell->Shows("\t0\r\ngcm> ")) << shell->seen();
}

TEST_F(JobsTest, JobsCanBeListedAndEnded) {
  shell->Type(std::string(kWatch) + " & events robot/arm/Control &\r");
  ASSERT_TRUE(shell->Shows("\t0\r\n")) << shell->seen();
  ASSERT_TRUE(shell->Shows("gcm: listening to ")) << shell->seen();
  shell->Type(
      "call robot/arm/Control.MoveTo duration=0.2 "
      "position=[0.1, 0, 0, -1, 0, 1, 0]\r");
  EXPECT_TRUE(shell->Shows("\trobot/arm/Control.GoalReached\t")) << shell->seen();

  shell->Type("jobs\r");
  EXPECT_TRUE(shell->Shows("\r\n1  " + std::string(kWatch) + "\r\n2  events robot/arm/Control\r\n"))
      << shell->seen();
  shell->Type("end 1\r");
  EXPECT_TRUE(shell->ShowsMatch("gcm: [1-9][0-9]* rows?, [0-9]+ lost")) << shell->seen();
  EXPECT_TRUE(shell->Shows("gcm: ended: 1  watch ")) << shell->seen();
  shell->Type("end 1\r");
  EXPECT_TRUE(shell->Shows("no background job has the number '1'")) << shell->seen();
  shell->Type("end\r");
  EXPECT_TRUE(shell->Shows("gcm: ended: 2  events ")) << shell->seen();
  shell->Type("jobs\r");
  EXPECT_TRUE(shell->Shows("jobs\r\ngcm> ")) << shell->seen();
}

TEST_F(JobsTest, JobsEndByThemselvesOrWithTheShell) {
  shell->Type(std::string(kWatch) + " --count 2 &\r");
  EXPECT_TRUE(shell->Shows("gcm: ended: 1  watch ")) << shell->seen();
  shell->Type(std::string(kWatch) + " &\r");
  ASSERT_TRUE(shell->Shows("\t0\r\n")) << shell->seen();

  shell->Type("exit\r");

  EXPECT_EQ(shell->program().Wait(), program::kOk);
}

TEST_F(JobsTest, AnInterruptEndsOnlyTheForegroundCommand) {
  shell->Type(std::string(kWatch) + " &\r");
  ASSERT_TRUE(shell->Shows("\t0\r\ngcm> ")) << shell->seen();
  shell->Type("events robot/arm/Control\r");
  ASSERT_TRUE(shell->Shows("gcm: listening to ")) << shell->seen();

  shell->Type("\x03");

  EXPECT_TRUE(shell->Shows(" events, ")) << shell->seen();
  EXPECT_TRUE(shell->Shows("\t0\r\ngcm> ")) << shell->seen();
}

TEST_F(JobsTest, OnlyLongRunningVerbsAtAPromptCanBeJobs) {
  shell->Type("ls &\r");
  EXPECT_TRUE(
      shell->Shows("gcm: only watch, events, hz and log can run in the background, but 'ls' "
                   "cannot"))
      << shell->seen();

  const Outcome piped =
      RunProgram({"/bin/sh", "-c", "echo '" + std::string(kWatch) + " &' | " + Command()});
  EXPECT_EQ(piped.exit_code, program::kUsage);
  EXPECT_THAT(piped.err, HasSubstr("gcm: & can be used only at the prompt of gcm shell"));
}

}  // namespace
