#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "gcm_console/output/json_schema.h"
#include "gcm_console/system_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The component `hall/crier` raises events when a command tells it to.
class EventsTest : public SystemFixture {
 protected:
  void SetUp() override {
    std::ofstream(file) << R"({"version": 1, "name": "hall", "processes": [{"name": "hall",
        "components": [{"name": "crier", "class": "Crier", "library": "crier"}]}]})";
    StartGcm();
    hall = StartLcm("hall", file);
    ASSERT_TRUE(EventuallySays({"ls", "hall"}, "crier\tactive")) << hall->err();
  }

  [[nodiscard]] std::unique_ptr<Program> Listen(Program::Words words) const {
    words.insert(words.begin(),
                 {Binary("gcm"), "--gcm", address, "--timeout", kTestTimeout, "events"});
    return std::make_unique<Program>(words);
  }
  static bool Says(const std::string& all, const std::string& text) {
    return all.find(text) != std::string::npos;
  }
  static bool EventuallyListens(const Program& events) {
    return EventuallyTrue([&] { return Says(events.err(), "gcm: listening to "); });
  }
  void Call(const std::string& command, const std::string& argument = "") const {
    Program::Words words = {"call", "hall/crier/Voice." + command};
    if (!argument.empty()) words.push_back(argument);
    const Outcome called = Gcm(words);
    ASSERT_EQ(called.exit_code, program::kOk) << called.err;
  }
  /// Opens a shell in which a call is made at once, although programs start slowly. A subscriber
  /// that is stopped for some seconds is dropped; events raised afterwards are not counted for it.
  [[nodiscard]] std::unique_ptr<Terminal> OpenShell() const {
    auto shell = std::make_unique<Terminal>(
        Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " shell",
        std::map<std::string, std::string>{{"HOME", home.path().string()}});
    EXPECT_TRUE(shell->Shows("gcm> ")) << shell->seen();
    return shell;
  }
  static std::vector<std::string> LinesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) lines.push_back(line);
    return lines;
  }

  /// Returns the number of lost Voice.Cried events that were reported.
  static std::size_t LostIn(const Program& events) {
    std::size_t all = 0;
    for (const std::string& line : LinesOf(events.err())) {
      unsigned long some = 0;
      int length = 0;  // stays 0 if the line ends or differs before %n
      std::sscanf(line.c_str(), "gcm: %lu events of hall/crier/Voice.Cried are lost%n", &some,
                  &length);
      if (length > 0) all += some;
    }
    return all;
  }

  /// Returns true for Ice, which closes an idle link. Plain TCP keeps it open.
  [[nodiscard]] bool ClosesSilentLinks() const {
    std::ifstream maps("/proc/" + std::to_string(gcm->pid()) + "/maps");
    const std::string all{std::istreambuf_iterator<char>(maps), {}};
    return all.find("libtendon_ice") != std::string::npos;
  }
  /// Returns true if the GCM has closed a link that this program still holds.
  [[nodiscard]] bool IsClosedByGcm(int pid) const {
    const std::string process = "/proc/" + std::to_string(pid);
    std::set<std::string> sockets;
    for (const auto& one : std::filesystem::directory_iterator(process + "/fd")) {
      sockets.insert(std::filesystem::read_symlink(one.path()).string());
    }
    std::ifstream all(process + "/net/tcp");
    for (std::string line; std::getline(all, line);) {
      constexpr unsigned kCloseWait = 8;  // TCP_CLOSE_WAIT
      unsigned remote_port = 0;
      unsigned state = 0;
      unsigned long inode = 0;
      const int read = std::sscanf(line.c_str(), "%*s %*s %*x:%x %x %*s %*s %*s %*s %*s %lu",
                                   &remote_port, &state, &inode);
      const bool is_ours = read == 3 && sockets.contains("socket:[" + std::to_string(inode) + "]");
      if (is_ours && state == kCloseWait && std::to_string(remote_port) == port) return true;
    }
    return false;
  }

  const std::string file = (home.path() / "hall.json").string();
  std::unique_ptr<Program> hall;
};

TEST_F(EventsTest, PrintsEventsOfAnInterfaceAsTheyAreRaised) {
  const auto events = Listen({"hall/crier/Voice", "--count", "4"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();

  Call("Cry", "3");
  Call("Fall");

  ASSERT_EQ(events->Wait(), program::kOk) << events->err();
  const auto lines = LinesOf(events->out());
  ASSERT_EQ(lines.size(), 4U) << events->out();
  for (int i = 0; i < 3; ++i) {
    EXPECT_THAT(lines[i], testing::ContainsRegex("^20[0-9-]+ [0-9:]+[.][0-9][0-9][0-9]\t"));
    EXPECT_THAT(lines[i], testing::EndsWith("\thall/crier/Voice.Cried\t" + std::to_string(i + 1)));
  }
  EXPECT_THAT(lines[3], testing::EndsWith("\thall/crier/Voice.Fell\t-"));
  EXPECT_THAT(events->err(), HasSubstr("gcm: 4 events, 0 lost\n"));
}

TEST_F(EventsTest, PatternsSelectEventsAndViewersMayListen) {
  const auto one = Listen({"hall/crier/Voice.Fell", "--count", "1", "--json", "--read-only"});
  const auto some = Listen({"**.Cri*", "--count", "1", "--jsonl"});
  ASSERT_TRUE(EventuallyListens(*one)) << one->err();
  ASSERT_TRUE(EventuallyListens(*some)) << some->err();

  Call("Cry", "1");
  Call("Fall");

  ASSERT_EQ(one->Wait(), program::kOk) << one->err();
  ASSERT_EQ(some->Wait(), program::kOk) << some->err();
  const json fell = json::parse(one->out());
  EXPECT_EQ(fell["schema"], 1);
  EXPECT_EQ(fell["path"], "hall/crier/Voice.Fell");
  EXPECT_EQ(fell["value"], nullptr);
  EXPECT_GT(fell["time_ns"], std::int64_t{1'600'000'000} * 1'000'000'000);
  const json cried = json::parse(some->out());
  EXPECT_EQ(cried["path"], "hall/crier/Voice.Cried");
  EXPECT_EQ(cried["value"], 1);
}

TEST_F(EventsTest, PrintsTheTimeOfRaisingEvenForLateEvents) {
  const auto late = Listen({"hall/crier/Voice.Fell", "--count", "1", "--json"});
  ASSERT_TRUE(EventuallyListens(*late)) << late->err();
  const auto shell = OpenShell();

  // Tries again if a step took too long.
  std::chrono::nanoseconds raised_before{0};
  const auto hears_it_late = [&] {
    const auto other = Listen({"hall/crier/Voice.Fell", "--count", "1"});
    if (!EventuallyListens(*other)) return false;
    late->Signal(SIGSTOP);
    shell->Type("call hall/crier/Voice.Fall\r");
    const bool is_raised = other->Wait() == program::kOk;
    raised_before = std::chrono::system_clock::now().time_since_epoch();
    late->Signal(SIGCONT);
    return is_raised && late->Wait(std::chrono::seconds(10)).has_value();
  };
  ASSERT_TRUE(EventuallyTrue(hears_it_late, std::chrono::minutes(2)))
      << late->err() << shell->seen();

  ASSERT_EQ(late->Wait(), program::kOk) << late->err();
  const json fell = json::parse(late->out());
  EXPECT_LE(fell["time_ns"], raised_before.count());
  EXPECT_GE(fell["uncertainty_ns"], 0);
  const json schema = json::parse(
      std::ifstream(std::string(TENDON_JSON_SCHEMAS) + "/data/events.json"), nullptr, false);
  EXPECT_EQ(MisfitOf(fell, schema), "");
}

TEST_F(EventsTest, PrintsASummaryWhenInterrupted) {
  const auto events = Listen({"hall/crier/*"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();
  Call("Fall");
  ASSERT_TRUE(EventuallyTrue([&] { return Says(events->out(), "Voice.Fell"); })) << events->err();

  events->Signal(SIGINT);

  EXPECT_EQ(events->Wait(), program::kInterrupted);
  EXPECT_THAT(events->err(), HasSubstr("gcm: 1 event, 0 lost\n"));
}

TEST_F(EventsTest, AResumedListenerReportsItsPauseAndReconnects) {
  if (!ClosesSilentLinks()) GTEST_SKIP() << "this build is without Ice: a stop costs no link";
  Program events({Binary("gcm"), "--gcm", address, "--timeout", "1s", "events", "hall/**"});
  ASSERT_TRUE(EventuallyListens(events)) << events.err();

  events.Signal(SIGSTOP);
  ASSERT_TRUE(EventuallyTrue([&] { return IsClosedByGcm(events.pid()); })) << gcm->err();
  events.Signal(SIGCONT);

  ASSERT_TRUE(EventuallyTrue([&] { return Says(events.err(), " is available again\n"); }))
      << events.err();
  EXPECT_THAT(events.err(),
              testing::ContainsRegex(
                  "gcm: this program was stopped, or got no processor time, for [0-9.]+ s"));
  EXPECT_THAT(events.err(), testing::Not(HasSubstr("start one with"))) << "it is there";
  EXPECT_TRUE(EventuallyTrue([&] {
    Call("Fall");
    return Says(events.out(), "Voice.Fell");
  })) << events.err();
  events.Signal(SIGINT);
  EXPECT_EQ(events.Wait(), program::kInterrupted);
}

TEST_F(EventsTest, ReportsTheLossAndReturnOfTheGcm) {
  const auto events = Listen({"hall/crier/Voice"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();

  gcm->Signal(SIGKILL);
  ASSERT_EQ(gcm->Wait(), 128 + SIGKILL);
  ASSERT_TRUE(EventuallyTrue([&] { return Says(events->err(), "gcm: no GCM at "); }));
  StartGcm();

  EXPECT_TRUE(EventuallyTrue([&] {
    return Says(events->err(), "gcm: the GCM at " + address + " is available again\n");
  })) << events->err();
  events->Signal(SIGINT);
  EXPECT_EQ(events->Wait(), program::kInterrupted);
}

TEST_F(EventsTest, PrintsTheCallsOfACommandWhosePathIsGiven) {
  const auto calls = Listen({"hall/crier/Voice.Cry", "--count", "1"});
  ASSERT_TRUE(EventuallyListens(*calls)) << calls->err();

  Call("Cry", "3");

  ASSERT_EQ(calls->Wait(), program::kOk) << calls->err();
  EXPECT_THAT(calls->out(), testing::HasSubstr("\thall/crier/Voice.Cry\t3\texecuted, from call\n"));
  EXPECT_THAT(calls->err(), HasSubstr("gcm: listening to 1 command of hall/crier/Voice\n"));
}

TEST_F(EventsTest, PrintsAllCommandsThatMatchIfWanted) {
  const auto calls = Listen({"hall/**", "--commands", "--count", "2", "--json"});
  ASSERT_TRUE(EventuallyTrue([&] {
    return Says(calls->err(), "commands of hall/crier/Voice") &&
           Says(calls->err(), "events of hall/crier/Voice");
  })) << calls->err();

  Call("Cry", "1");

  ASSERT_EQ(calls->Wait(), program::kOk) << calls->err();
  std::set<std::string> paths;
  for (const std::string& line : LinesOf(calls->out())) {
    const json one = json::parse(line);
    paths.insert(one["path"].get<std::string>());
    if (one["path"] != "hall/crier/Voice.Cry") continue;
    EXPECT_EQ(one["value"]["outcome"], "executed");
    EXPECT_EQ(one["value"]["argument"], 1);
    EXPECT_EQ(one["value"]["client"], "call");
  }
  EXPECT_EQ(paths, (std::set<std::string>{"hall/crier/Voice.Cried", "hall/crier/Voice.Cry"}));
}

TEST_F(EventsTest, ForLimitsTheDuration) {
  const auto events = Listen({"hall/crier/Voice", "--for", "1ms"});
  EXPECT_EQ(events->Wait(), program::kOk) << events->err();
  EXPECT_THAT(events->err(), HasSubstr("gcm: 0 events, 0 lost\n"));
}

TEST_F(EventsTest, CountsEventsLostToAFullQueue) {
  constexpr int kTimes = 5000;
  const auto events = Listen({"hall/crier/Voice"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();

  Call("Cry", std::to_string(kTimes));
  const auto printed = [&] { return LinesOf(events->out()).size(); };
  const auto lost = [&] { return LostIn(*events); };

  EXPECT_TRUE(EventuallyTrue([&] { return printed() + lost() == kTimes; }))
      << printed() << " + " << lost();
  EXPECT_GE(printed(), 1024U);
  events->Signal(SIGINT);
  ASSERT_EQ(events->Wait(), program::kInterrupted);
  EXPECT_THAT(events->err(), HasSubstr("gcm: " + std::to_string(printed()) + " events, " +
                                       std::to_string(lost()) + " lost\n"));
}

TEST_F(EventsTest, AStoppedListenerDelaysNoOtherAndCountsItsLosses) {
  constexpr int kTimes = 5000;
  constexpr int kCries = 5;
  const auto stopped = Listen({"hall/crier/Voice.Cried"});
  const auto other = Listen({"hall/crier/Voice.Fell", "--count", "1"});
  ASSERT_TRUE(EventuallyListens(*stopped)) << stopped->err();
  ASSERT_TRUE(EventuallyListens(*other)) << other->err();

  const auto shell = OpenShell();
  std::string line;
  for (int i = 0; i < kCries; ++i) {
    line += "call hall/crier/Voice.Cry " + std::to_string(kTimes) + "; ";
  }

  stopped->Signal(SIGSTOP);
  shell->Type(line + "call hall/crier/Voice.Fall\r");
  EXPECT_EQ(other->Wait(), program::kOk) << other->err() << shell->seen();
  stopped->Signal(SIGCONT);

  const auto known = [&] { return LinesOf(stopped->out()).size() + LostIn(*stopped); };
  EXPECT_TRUE(EventuallyTrue([&] { return known() == kCries * kTimes; })) << known();
}

TEST_F(EventsTest, ContinuesAfterARestartOfGcmAndProcess) {
  const auto events = Listen({"hall/crier/Voice"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();
  const auto raised = [&](std::size_t times) {
    return EventuallyTrue([&] { return LinesOf(events->out()).size() >= times; });
  };

  gcm->Signal(SIGKILL);
  ASSERT_TRUE(EventuallyTrue([&] { return Says(events->err(), "no GCM at"); }));
  StartGcm();
  ASSERT_TRUE(EventuallySays({"ls", "hall"}, "crier\tactive")) << hall->err();
  Call("Fall");
  ASSERT_TRUE(raised(1)) << events->err();

  hall->Signal(SIGKILL);
  ASSERT_TRUE(EventuallyTrue([&] { return Says(events->err(), "process 'hall'"); }));
  hall = StartLcm("hall", file);
  ASSERT_TRUE(EventuallyTrue([&] {
    const auto lines = LinesOf(events->err());
    return std::count(lines.begin(), lines.end(),
                      "gcm: listening to 2 events of hall/crier/Voice") == 2;
  })) << events->err();
  Call("Cry", "1");
  EXPECT_TRUE(raised(2)) << events->err();

  events->Signal(SIGINT);
  EXPECT_EQ(events->Wait(), program::kInterrupted);
}

TEST_F(EventsTest, NoReconnectEndsWhenTheProcessIsLost) {
  const auto events = Listen({"hall/crier/Voice", "--no-reconnect"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();

  hall->Signal(SIGKILL);

  EXPECT_EQ(events->Wait(), program::kRefused);
  EXPECT_THAT(events->err(), HasSubstr("gcm: process 'hall' was lost"));
}

TEST_F(EventsTest, NoReconnectExitsAsUnreachableWhenTheGcmIsLost) {
  const auto events = Listen({"hall/crier/Voice", "--no-reconnect"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();

  gcm->Signal(SIGKILL);

  EXPECT_EQ(events->Wait(), program::kUnreachable) << events->err();
  const auto lines = LinesOf(events->err());
  const auto tells = [](const std::string& line) { return line.starts_with("gcm: no GCM at "); };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), tells), 1) << events->err();
  EXPECT_TRUE(tells(lines.back())) << events->err();
}

TEST_F(EventsTest, ListensToComponentsCreatedLater) {
  const auto events = Listen({"hall/*/Voice"});
  ASSERT_TRUE(EventuallyListens(*events)) << events->err();

  ASSERT_EQ(Gcm({"create", "Crier", "hall/herald"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"start", "hall/herald"}).exit_code, program::kOk);
  ASSERT_TRUE(EventuallyTrue([&] {
    return Says(events->err(), "gcm: listening to 2 events of hall/herald/Voice");
  })) << events->err();
  ASSERT_EQ(Gcm({"call", "hall/herald/Voice.Fall"}).exit_code, program::kOk);
  EXPECT_TRUE(EventuallyTrue([&] { return Says(events->out(), "hall/herald/Voice.Fell"); }));

  // After a component is removed, gcm waits until it returns.
  ASSERT_EQ(Gcm({"stop", "hall/herald"}).exit_code, program::kOk);
  ASSERT_EQ(Gcm({"rm", "hall/herald"}).exit_code, program::kOk);
  EXPECT_TRUE(EventuallyTrue([&] { return Says(events->err(), "'herald'"); })) << events->err();
}

TEST_F(EventsTest, MistakesAreExplained) {
  const auto refused = [&](const Program::Words& words, int exit_code, const std::string& text) {
    Program::Words all = {"events"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = Gcm(all);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  refused({}, program::kUsage, "gcm events --help tells more");
  refused({"hall/crier/Voice", "--count", "0"}, program::kUsage, "--count");
  refused({"hall/crier/Voice.Fel"}, program::kNotFound, "did you mean 'Fell'?");
  refused({"hall/crier"}, program::kUsage, "or, for all interfaces in it, give 'hall/crier/**'");
  refused({"hall/crier/state"}, program::kNotFound, "'hall/crier/state' has no events");
  refused({"nowhere/**"}, program::kNotFound, "no event matches 'nowhere/**'");
}

}  // namespace
