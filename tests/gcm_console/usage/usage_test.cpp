#include <gcm_console/verbs/verb.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <tendon/base/os/process.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <set>

#include "gcm_console/system_fixture.h"

namespace {

using testing::HasSubstr;

class UsageTest : public SystemFixture {};

void ExpectOneSentence(const Outcome& outcome, int exit_code, const std::string& sentence) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_THAT(outcome.err, testing::StartsWith("gcm: "));
  EXPECT_THAT(outcome.err, HasSubstr(sentence));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(UsageTest, ExplainsAMistypedCommandLine) {
  struct Case {
    Program::Words words;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {{}, "a verb is missing; gcm --help tells more"},
      {{"conect"}, "no verb 'conect'; did you mean 'connect'? to list the verbs: gcm --help"},
      {{"frobnicate"}, "no verb 'frobnicate'; to list the verbs: gcm --help"},
      {{"--gcm=a", "conect"}, "no verb 'conect'; did you mean 'connect'?"},
      {{"--tiemout", "5", "ls"}, "no option '--tiemout'; did you mean '--timeout'?"},
      {{"ls", "--jsn"}, "no option '--jsn'; did you mean '--json'? gcm ls --help tells more"},
      {{"watch", "a", "--cont=3"}, "no option '--cont'; did you mean '--count'?"},
      {{"ls", "a", "b"}, "'b' is one word too many; gcm ls --help tells more"},
      {{"connect", "a/b/C"}, "provided is missing; gcm connect --help tells more"},
      {{"--gcm"}, "--gcm needs a value; gcm --help tells more"},
      {{"--gcm", "a", "--gcm", "b", "ls"}, "--gcm is given 2 times"},
      {{"--gcm=", "ls"}, "--gcm needs a value; gcm --help tells more"},
      {{"--gcm=", "conect"}, "no verb 'conect'; did you mean 'connect'?"},
      {{"ls", "--timeout="}, "--timeout needs a value; gcm --help tells more"},
      {{"watch", "a", "--count=", "3"}, "--count needs a value; gcm --help tells more"},
      {{"cert", "issue", "a", "--role=", "b"}, "--role needs a value; gcm --help tells more"},
      {{"ls", "-l", "-l"}, "--long is given 2 times; gcm ls --help tells more"},
      {{"ls", "-l", "--long", "-l"}, "--long is given 3 times; gcm ls --help tells more"},
      {{"-q", "ls", "-q"}, "--quiet is given 2 times; gcm ls --help tells more"},
      {{"--timeout", "soon", "ls"}, "--timeout: "},
      {{"--timeout", "0", "ls"}, "--timeout: "},
      {{"--middleware", "pigeon", "ls"}, "--middleware: pigeon not in"},
      {{"watch", "a", "--hz", "-1"}, "--hz: expected a number above 0, got '-1'"},
      {{"watch", "a", "--hz", "nan"}, "--hz: expected a number above 0, got 'nan'"},
      {{"watch", "a", "--count", "0"}, "--count: expected a whole number above 0, got '0'"},
      {{"watch", "a", "--count", "1.5"}, "--count: expected a whole number above 0, got '1.5'"},
      {{"hz", "a", "--count", "x"}, "--count: expected a whole number above 0, got 'x'"},
      {{"history", "--count", "x"}, "--count: expected a whole number above 0, got 'x'"},
      {{"history", "--count", "-1"}, "--count: expected a whole number above 0, got '-1'"},
      {{"undo", "--step", "0"}, "--step: expected a whole number above 0, got '0'"},
      {{"undo", "2", "--step", "1"}, "count excludes --step"},
      {{"undo", "--skip", "2"}, "count excludes --skip"},
      {{"--gcm", "", "ls"}, "--gcm: expected an address such as 127.0.0.1:10705, got ''"},
      {{"undo", "0"}, "count: expected a whole number above 0, got '0'"},
      {{"top", "--sort", "x"}, "--sort: x not in {name,"},
      {{"log-level", "a", "loud"}, "level: loud not in {debug,info,warning,error}"},
      {{"completion", "ksh"}, "shell: ksh not in {bash,zsh,fish}"},
      {{"cert", "isue"},
       "no verb 'isue'; did you mean 'issue'? to list the verbs: gcm cert --help"},
      {{"watch", "a", "--for", "1h"}, "--for: expected a time such as 500ms, 10s or 2min"},
  };
  for (const Case& one : cases) {
    ExpectOneSentence(Typed(one.words), program::kUsage, one.sentence);
  }
}

TEST_F(UsageTest, ExplainsHowToWriteANumber) {
  struct Case {
    Program::Words words;
    std::string sentence;
  };
  const Case cases[] = {
      {{"watch", "a", "--hz", "0,5"},
       "--hz: expected a number above 0, got '0,5'; write 0.5: use a point as the decimal sign"},
      {{"watch", "a", "--hz", "1,234"}, "write 1.234 or 1234: use a point as the decimal sign"},
      {{"watch", "a", "--hz", "inf"}, "--hz: expected a number above 0, got 'inf'"},
      {{"watch", "a", "--hz", "1e999"}, "--hz: expected a number above 0, got '1e999'"},
      {{"watch", "a", "--for", "0,5s"}, "got '0,5s'; write 0.5s: use a point as the decimal sign"},
      {{"watch", "a", "--for", "1'000ms"}, "write 1000ms: use no separator between thousands"},
      {{"watch", "a", "--for", "5sec"}, "--for: expected a time such as 500ms, 10s or 2min"},
      {{"--timeout", "0,5s", "ls"}, "got '0,5s'; write 0.5s: use a point as the decimal sign"},
      {{"--timeout", "1.5", "ls"}, "got '1.5'; write whole milliseconds"},
      {{"--timeout", "+1.5", "ls"}, "got '+1.5'; write whole milliseconds"},
      {{"--timeout", "15e-1", "ls"}, "got '15e-1'; write whole milliseconds"},
      {{"watch", "a", "--count", "010"}, "got '010'; write 10"},
      {{"watch", "a", "--count", "0x10"}, "got '0x10'; write 16"},
      {{"watch", "a", "--count", "18446744073709551616"}, "--count: expected a whole number"},
      {{"undo", "010"}, "count: expected a whole number above 0, got '010'; write 10"},
  };
  for (const Case& one : cases) {
    ExpectOneSentence(Typed(one.words), program::kUsage, one.sentence);
  }
}

TEST_F(UsageTest, AllFormsOfHelpWork) {
  for (const Program::Words& words : {Program::Words{"--help"}, {"help"}, {"-h"}}) {
    const Outcome help = Typed(words);
    EXPECT_EQ(help.exit_code, program::kOk);
    EXPECT_THAT(help.out, testing::StartsWith("gcm: show and control a system of components"));
    EXPECT_EQ(help.err, "");
  }
  EXPECT_EQ(Typed({"help", "watch"}).out, Typed({"watch", "--help"}).out);
  ExpectOneSentence(Typed({"help", "wacth"}), program::kUsage, "did you mean 'watch'?");
}

/// Returns the shortest valid command line of each verb that needs a GCM.
std::map<std::string, Program::Words> LinesThatNeedAGcm(const std::string& folder) {
  const std::string file = folder + "/empty.json";
  std::ofstream(file) << R"({"version": 1, "name": "empty", "processes": []})";
  return {{"status", {}},
          {"find", {"a"}},
          {"graph", {}},
          {"ls", {}},
          {"tree", {}},
          {"show", {"a"}},
          {"top", {}},
          {"get", {"a/b/c.d"}},
          {"watch", {"a/b/c.d"}},
          {"events", {"a/b/C"}},
          {"hz", {"a/b/state"}},
          {"plot", {"a/b/c.d"}},
          {"log", {}},
          {"log-level", {"a", "info"}},
          {"call", {"a/b/c.d"}},
          {"load", {"a"}},
          {"classes", {}},
          {"create", {"A", "b"}},
          {"configure", {"a/b"}},
          {"set", {"a/b", "c"}},
          {"start", {"a/b"}},
          {"suspend", {"a/b"}},
          {"stop", {"a/b"}},
          {"restart", {"a/b"}},
          {"rm", {"a/b"}},
          {"kill", {"a"}},
          {"forget", {"a"}},
          {"connect", {"a/b/C", "d/e/F"}},
          {"disconnect", {"a/b/C"}},
          {"candidates", {"a/b/C"}},
          {"explain", {"a/b/C"}},
          {"record", {"**", "-o", folder + "/run.mcap", "--for", "1s"}},
          {"replay", {folder + "/run.mcap"}},
          {"save-last", {"5s", "**", "-o", folder + "/last.mcap"}},
          {"save", {folder + "/new.json"}},
          {"diff", {file}},
          {"plan", {file}},
          {"apply", {file}},
          {"undo", {}},
          {"history", {}}};
}

/// The verbs that need no GCM, wait for a GCM, or report the problem of the GCM.
const std::set<std::string> kNeedNoGcm = {"import", "cert", "serve",      "broker", "doctor",
                                          "shell",  "run",  "info",       "cut",    "recover",
                                          "export", "help", "completion", "version"};

TEST_F(UsageTest, EveryVerbExplainsHowToStartAGcm) {
  const auto lines = LinesThatNeedAGcm(home.path().string());
  for (const console::Verb& verb : console::AllVerbs()) {
    const auto line = lines.find(verb.name);
    EXPECT_NE(line == lines.end(), !kNeedNoGcm.contains(verb.name)) << verb.name;
    if (line == lines.end()) continue;
    Program::Words words = {verb.name, "--timeout", "50"};
    words.insert(words.end(), line->second.begin(), line->second.end());
    const Outcome outcome = Typed(words);
    ExpectOneSentence(outcome, program::kUnreachable, "no GCM at " + address);
    EXPECT_THAT(outcome.err, HasSubstr("start one with: gcm serve")) << verb.name;
  }
}

TEST_F(UsageTest, ASecondGcmOnOnePortNamesTheFirst) {
  StartGcm();

  ExpectOneSentence(Typed({"serve"}), program::kRefused,
                    address + " is in use by pid " + std::to_string(gcm->pid()) +
                        " (gcm); use the running GCM, or give another port with --gcm");
}

TEST_F(UsageTest, ABrokerOnATakenPortNamesItsHolder) {
  StartGcm();

  ExpectOneSentence(Typed({"broker", "--listen", address}), program::kRefused,
                    address + " is in use by pid " + std::to_string(gcm->pid()) + " (gcm)");
}

TEST_F(UsageTest, RejectsOnePortForGcmAndFanOut) {
  ExpectOneSentence(Typed({"serve", "--broker", "localhost:" + port}), program::kUsage,
                    "--broker and --gcm are both " + address +
                        ", but two programs cannot share a port; give --broker another port");
}

TEST_F(UsageTest, ServeWarnsIfItCannotKeepAHistory) {
  const Program served({Binary("gcm"), "--gcm", address, "serve"},
                       {{"XDG_STATE_HOME", "/proc/nowhere"}});

  EXPECT_TRUE(EventuallyTrue([&] {
    return served.err().find("the history is not saved: cannot write /proc/") != std::string::npos;
  })) << served.err();
  EXPECT_THAT(served.err(),
              HasSubstr("only until this GCM ends; make the folder writable, or choose "
                        "another folder with XDG_STATE_HOME"));
  EXPECT_TRUE(EventuallyTrue([&] { return served.out().starts_with("GCM at "); }));
}

TEST_F(UsageTest, WarnsWhenRunningAsRoot) {
  if (!tendon::os::RunsAsRoot()) GTEST_SKIP() << "only root can try: its warning was not seen";

  StartGcm();

  EXPECT_THAT(gcm->err(), HasSubstr("runs as root, but a GCM does not need the rights of root"));
}

TEST_F(UsageTest, RejectsABadAddress) {
  for (const char* bad : {"127.0.0.1:abc", "127.0.0.1:65536", "127.0.0.1:-1", "127.0.0.1:0"}) {
    ExpectOneSentence(Typed({"--gcm", bad, "ls"}), program::kUsage, "expected 1..65535");
  }
  for (const char* bad : {"127.0.0.1:abc", "127.0.0.1:65536", "127.0.0.1:-1"}) {
    ExpectOneSentence(Typed({"--gcm", bad, "serve"}), program::kUsage, "expected 0..65535");
  }
  ExpectOneSentence(Typed({"--gcm", "127.0.0.1:abc", "ls"}), program::kUsage,
                    "port 'abc': expected 1..65535");
  ExpectOneSentence(Typed({"--gcm", "::1:10", "ls"}), program::kUsage, "in brackets");
  ExpectOneSentence(Typed({"--gcm", ":10705", "ls"}), program::kUsage, "expected a host");
}

TEST_F(UsageTest, AHostWithoutAPortUsesTheDefaultPort) {
  ExpectOneSentence(Typed({"--gcm", "192.0.2.1", "ls"}), program::kDenied, "host '192.0.2.1'");
  ExpectOneSentence(Typed({"--gcm", "[::2]", "ls"}), program::kDenied, "host '::2'");
}

TEST_F(UsageTest, ARemoteAddressNeedsInsecure) {
  for (const char* verb : {"ls", "serve"}) {
    ExpectOneSentence(Typed({"--gcm", "192.0.2.1:10705", verb}), program::kDenied, "--insecure");
  }
}

TEST_F(UsageTest, ReportsACookieThatCannotBeWritten) {
  const Outcome outcome = RunProgram({Binary("gcm"), "--gcm", address, "serve"},
                                     {{"XDG_RUNTIME_DIR", "/proc/nowhere"}});

  ExpectOneSentence(outcome, program::kDenied, "/proc/nowhere");
}

TEST_F(UsageTest, FailsWhenOutputCannotBeWritten) {
  StartGcm();

  for (const char* words : {"ls --json > /dev/full", "tree --json >&-", "--help >/dev/full"}) {
    ExpectOneSentence(Shell(words), program::kRefused, "cannot write");
  }
}

TEST_F(UsageTest, AClosedPipeEndsItSilently) {
  StartGcm();

  const std::string list = Binary("gcm") + " --gcm " + address + " ls --json";
  const Outcome outcome = RunProgram({"/bin/sh", "-c",
                                      "{ code=0; while [ $code = 0 ]; do " + list +
                                          "; code=$?; done; echo $code >&2; }" + " | true"});

  EXPECT_EQ(outcome.err, "1\n");
}

TEST_F(UsageTest, RunsWithClosedStandardStreams) {
  StartGcm();

  const Outcome outcome = Shell("ls --json 2>&- <&-");

  EXPECT_EQ(outcome.exit_code, program::kOk);
  EXPECT_THAT(outcome.out, HasSubstr("\"schema\": 1"));
}

}  // namespace
