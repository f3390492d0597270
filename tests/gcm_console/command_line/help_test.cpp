#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "gcm_console/system_fixture.h"

namespace {

using testing::HasSubstr;

/// Runs `gcm WORDS...` as a beginner types it. No GCM is needed.
class HelpTest : public SystemFixture {
 protected:
  /// Returns the verbs in the output of `gcm help`.
  std::vector<std::string> Verbs() const {
    const std::string help = Typed({"help"}).out;
    const std::string listed = help.substr(0, help.find("\noptions\n"));
    static const std::regex kVerb("\n  ([a-z-]+)  ");
    std::vector<std::string> verbs;
    for (std::sregex_iterator it(listed.begin(), listed.end(), kVerb), end; it != end; ++it) {
      verbs.push_back((*it)[1]);
    }
    return verbs;
  }
};

TEST_F(HelpTest, EveryVerbIsListedAndHasAPage) {
  const auto verbs = Verbs();

  EXPECT_GE(verbs.size(), 20U);
  EXPECT_THAT(verbs, testing::IsSupersetOf({"ls", "watch", "connect", "shell", "help", "version"}));
  // Complete is used only by programs.
  EXPECT_THAT(verbs, testing::Not(testing::Contains("complete")));
  for (const std::string& verb : verbs) {
    const Outcome page = Typed({"help", verb});
    EXPECT_EQ(page.exit_code, program::kOk) << verb;
    EXPECT_THAT(page.out, testing::StartsWith("gcm " + verb + ": "));
    EXPECT_THAT(page.out, HasSubstr("\nusage: gcm " + verb));
    EXPECT_EQ(page.out, Typed({verb, "--help"}).out);
  }
  EXPECT_THAT(Typed({"help", "cert", "issue"}).out, HasSubstr("usage: gcm cert issue NAME"));
}

TEST_F(HelpTest, NoLineIsWiderThanTheTerminal) {
  for (const std::string& verb : Verbs()) {
    std::istringstream lines(Typed({"help", verb}).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(HelpTest, ListsAllExitCodes) {
  const std::string topic = Typed({"help", "exit-codes"}).out;

  for (const int code : {program::kOk, program::kRefused, program::kUsage, program::kUnreachable,
                         program::kNotFound, program::kIncompatible, program::kTimeout,
                         program::kDenied, program::kPartial, program::kInterrupted}) {
    EXPECT_THAT(topic, HasSubstr("\n  " + std::to_string(code) + " "));
  }
}

TEST_F(HelpTest, TopicsExplainMoreThanVerbs) {
  EXPECT_THAT(Typed({"help", "paths"}).out, HasSubstr("robot/arm/state.Joints.position[0]"));
  EXPECT_THAT(Typed({"help", "output"}).out, HasSubstr("--no-header"));
  const Outcome unknown = Typed({"help", "pahts"});
  EXPECT_EQ(unknown.exit_code, program::kUsage);
  EXPECT_EQ(unknown.err,
            "gcm: no verb or topic 'pahts'; did you mean 'paths'? to list all verbs and topics: "
            "gcm help\n");
}

TEST_F(HelpTest, PrintsTheVersionAsTextAndJson) {
  EXPECT_THAT(Typed({"--version"}).out, testing::StartsWith("gcm 0."));
  EXPECT_THAT(Typed({"version"}).out, HasSubstr(", protocol "));
  const auto document = nlohmann::json::parse(Typed({"version", "--json"}).out);
  EXPECT_EQ(document["schema"], 1);
  EXPECT_GT(document["protocol"], 0);
}

TEST_F(HelpTest, TheManualHasAPageForEachVerb) {
  ASSERT_EQ(Typed({"help", "--manual", home.path().string()}).exit_code, program::kOk);

  for (const std::string& verb : Verbs()) {
    EXPECT_TRUE(std::filesystem::exists(home.path() / ("gcm-" + verb + ".1"))) << verb;
  }
  if (std::system("command -v man >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no man here";
  const Outcome read = RunProgram(
      {"/bin/sh", "-c",
       "MANWIDTH=80 LC_ALL=C.UTF-8 man --warnings -l '" + (home.path() / "gcm.1").string() + "'"});
  EXPECT_THAT(read.out, HasSubstr("EXIT-CODES"));
  EXPECT_THAT(read.out, HasSubstr("--read-only"));
  EXPECT_EQ(read.err, "");
}

TEST_F(HelpTest, ATimeoutMayHaveAUnit) {
  for (const char* good : {"50", "50ms", "0.05s"}) {
    EXPECT_EQ(Typed({"--timeout", good, "ls"}).exit_code, program::kUnreachable) << good;
  }
  EXPECT_THAT(Typed({"--timeout", "5parsec", "ls"}).err,
              HasSubstr("--timeout: expected a time of 1 ms to 60 min, such as 500ms, 5s or 2min, "
                        "got '5parsec'"));
}

TEST_F(HelpTest, RejectsAWordThatIsNoAddress) {
  const Outcome outcome = Typed({"--gcm", "nonsense", "ls"});

  EXPECT_EQ(outcome.exit_code, program::kUsage);
  EXPECT_EQ(outcome.err,
            "gcm: --gcm: 'nonsense' is not an address on this machine, such as 127.0.0.1:10705; to "
            "use a host with this name, give a --certificate\n");
}

}  // namespace
