#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using testing::HasSubstr;

/// Tests with terminals that have few abilities, or do not tell their abilities.
class OddTerminalTest : public DemoFixture {
 protected:
  /// Returns a command line that runs gcm with these `variables`. `-u NAME` removes a variable.
  std::string Command(const std::string& variables, const std::string& words) const {
    return "env " + variables + " " + Binary("gcm") + " --gcm " + address + " --timeout " +
           kTestTimeout + " " + words;
  }
  std::map<std::string, std::string> Environment() const {
    return {{"XDG_STATE_HOME", home.path().string()}, {"HOME", home.path().string()}};
  }
};

TEST_F(OddTerminalTest, ADumbTerminalGetsPlainLines) {
  for (const char* variables : {"-u TERM", "TERM=dumb", "TERM="}) {
    Terminal top(Command(variables, "top --sort name"));
    EXPECT_EQ(top.program().Wait(), program::kOk) << top.seen();
    EXPECT_TRUE(top.Shows("robot/arm")) << top.seen();
    EXPECT_THAT(top.seen(), testing::Not(HasSubstr("\x1b")));

    Terminal plot(Command(variables, "plot robot/arm/state.Joints.position[0] --window 500ms"));
    EXPECT_EQ(plot.program().Wait(), program::kOk) << plot.seen();
    EXPECT_TRUE(plot.Shows(" rad\r\n")) << plot.seen();
    EXPECT_THAT(plot.seen(), testing::Not(HasSubstr("\x1b")));
  }
}

TEST_F(OddTerminalTest, TheShellWorksOnEachTerminal) {
  for (const char* variables : {"-u TERM", "TERM=dumb", "TERM=no-such-terminal"}) {
    Terminal shell(Command(variables, "shell"), Environment());
    ASSERT_TRUE(shell.Shows("gcm> ")) << variables << shell.seen();
    shell.Type("status\r");  // the prompt shows the output when the catalogue has arrived
    ASSERT_TRUE(shell.Shows("see gcm doctor\r\ngcm> ")) << variables << shell.seen();
    shell.Type("cd rob\t/ar\t\r");
    EXPECT_TRUE(shell.Shows("robot/arm> ")) << variables << shell.seen();
    shell.Type("exit\r");
    EXPECT_EQ(shell.program().Wait(), program::kOk);
  }
}

TEST_F(OddTerminalTest, TwentyColumnsAreEnough) {
  constexpr unsigned short kNarrow = 20;
  Terminal top(Command("", "top --sort name"), {}, kNarrow);
  ASSERT_TRUE(top.Shows("\x1b[?7l")) << top.seen();  // long lines are cut off at the right edge
  EXPECT_TRUE(top.Shows("desk/old_arm")) << top.seen();
  EXPECT_TRUE(top.Shows("\r\nkeys: q end; sort")) << top.seen();
  top.Type("q");
  EXPECT_EQ(top.program().Wait(), program::kOk);

  Terminal shell(Command("", "shell"), Environment(), kNarrow);
  ASSERT_TRUE(shell.Shows("gcm> "));
  shell.Type("get robot/arm/state.Joints.position[0]; version\r");
  EXPECT_TRUE(shell.Shows("\r\n0\r\ngcm 0.")) << shell.seen();
  shell.Type("exit\r");
  EXPECT_EQ(shell.program().Wait(), program::kOk);
}

TEST_F(OddTerminalTest, AcceptsUnicodeInputInAnyLocale) {
  for (const char* locale : {"C", "POSIX", "xx_YY.UTF-8", "de_DE.ISO-8859-1"}) {
    Terminal shell(Command("LC_ALL=" + std::string(locale), "shell"), Environment());
    ASSERT_TRUE(shell.Shows("gcm> "));
    shell.Type(
        "ls k\xc3\xbc"
        "che\r");
    EXPECT_TRUE(
        shell.Shows("'k\xc3\xbc"
                    "che'"))
        << locale << shell.seen();
    shell.Type("exit\r");
    EXPECT_EQ(shell.program().Wait(), program::kOk);
  }
}

}  // namespace
