#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <csignal>

#include "gcm_console/system_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using testing::HasSubstr;

/// Tests the completion of words that only a process knows.
class LiveCompletionTest : public SystemFixture {
 protected:
  void SetUp() override {
    home.Write("hall.json", R"({"version": 1, "name": "hall", "processes": [{"name": "hall",
        "components": [{"name": "crier", "class": "Crier", "library": "crier"}]}]})");
    StartGcm();
    hall = StartLcm("hall", (home.path() / "hall.json").string());
    ASSERT_TRUE(EventuallySays({"ls", "hall"}, "crier\tactive")) << hall->err();
    shell = std::make_unique<Terminal>(
        // If a key press waited for a reply with this time-out, the test would fail.
        Binary("gcm") + " --gcm " + address + " --timeout 10min shell",
        std::map<std::string, std::string>{{"XDG_STATE_HOME", home.path().string()},
                                           {"HOME", home.path().string()}},
        kWide);
    ASSERT_TRUE(shell->Shows("gcm> "));
    shell->Type("status\r");  // the prompt shows the output when the catalogue has arrived
    ASSERT_TRUE(shell->Shows("all is well\r\ngcm> ")) << shell->seen();
  }
  /// Types the line, which contains a Tab, until the output contains `text`. The reply of the
  /// process may arrive too late for the first Tab.
  bool Says(const std::string& line, const std::string& text) const {
    return EventuallyTrue([&] {
      shell->Type(line + "\r");
      return shell->Shows("\r\ngcm> ") && shell->seen().find(text) != std::string::npos;
    });
  }

  static constexpr unsigned short kWide = 200;
  std::unique_ptr<Program> hall;
  std::unique_ptr<Terminal> shell;
};

TEST_F(LiveCompletionTest, CallCompletesFieldsAndEnumNames) {
  EXPECT_TRUE(Says("call hall/crier/Voice.Sing hi\t", "\r\n\"high\"\r\n")) << shell->seen();
  EXPECT_TRUE(Says("call hall/crier/Voice.Repeat te\t'a b' to\th\tlo\tt\t",
                   R"({"text":"a b","tone":"high","loud":true})"))
      << shell->seen();
  shell->Type("call hall/crier/Voice.Repeat a\\ b \t");
  EXPECT_TRUE(shell->Shows("\r\nmiddle")) << shell->seen();
  EXPECT_TRUE(shell->Shows("\r\ntone=")) << shell->seen();
}

TEST_F(LiveCompletionTest, SetCompletesParameterValues) {
  ASSERT_EQ(Gcm({"stop", "hall/crier"}).exit_code, program::kOk);

  EXPECT_TRUE(Says("set hall/crier to\th\t--dry-run", R"(would be set from "middle" to "high")"))
      << shell->seen();
  EXPECT_TRUE(Says("set hall/crier vol\t\t--dry-run", "volume\tis 0.5 already")) << shell->seen();
}

TEST_F(LiveCompletionTest, CompletesClassesAndPluginsOfTheProcesses) {
  EXPECT_TRUE(Says("create Cr\thall/herald --dry-run", "hall/herald\twould be created"))
      << shell->seen();
  EXPECT_TRUE(Says("load coun\t--dry-run", "hall counter\twould be loaded")) << shell->seen();
  EXPECT_TRUE(
      Says("create Counter hall/ticks --library=coun\t--dry-run", "hall/ticks\twould be created"))
      << shell->seen();
}

TEST_F(LiveCompletionTest, ASilentProcessDoesNotBlockCompletion) {
  hall->Signal(SIGSTOP);
  shell->Type("load coun\t\x03");
  EXPECT_TRUE(shell->Shows("^C\r\ngcm> ")) << shell->seen();
  hall->Signal(SIGCONT);
}

TEST_F(LiveCompletionTest, CompletesFromTheCacheWithoutTheProcess) {
  ASSERT_TRUE(Says("load coun\t--dry-run", "hall counter\twould be loaded")) << shell->seen();

  hall->Signal(SIGSTOP);
  shell->Type("load coun\t");

  EXPECT_TRUE(shell->Shows("ter")) << shell->seen();
  hall->Signal(SIGCONT);
}

TEST_F(LiveCompletionTest, CtrlRSearchesTheHistory) {
  for (const char* line : {"ls hall/crier\r", "version\r", "help paths\r"}) {
    shell->Type(line);
    ASSERT_TRUE(shell->Shows("\r\ngcm> ")) << shell->seen();
  }

  shell->Type("\x12vers");
  ASSERT_TRUE(shell->Shows("bck:")) << shell->seen();
  ASSERT_TRUE(shell->Shows("version")) << shell->seen();
  shell->Type("\r");

  EXPECT_TRUE(shell->Shows("protocol")) << shell->seen();
}

}  // namespace
