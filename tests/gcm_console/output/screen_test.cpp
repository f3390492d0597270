#include <gcm_console/output/curve_picture.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <program/exit_code.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "gcm_console/demo_fixture.h"
#include "gcm_console/terminal.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(BrailleCanvas, EachLetterShowsEightDots) {
  console::BrailleCanvas canvas(2, 1);
  EXPECT_EQ(canvas.Row(0), "\u2800\u2800");

  canvas.Set(0, 0);
  canvas.Set(3, 3);
  canvas.Set(4, 0);  // outside of the canvas

  EXPECT_EQ(canvas.Row(0), "\u2801\u2880");
}

TEST(BrailleCanvas, ALineHasNoHoles) {
  console::BrailleCanvas canvas(2, 1);

  canvas.Line(0, 0, 3, 3);

  EXPECT_EQ(canvas.Row(0), "\u2811\u2884");
}

using ScreenTest = DemoFixture;

TEST_F(ScreenTest, TopPrintsOneTableIntoAPipe) {
  EXPECT_TRUE(EventuallyTrue([this] {
    const std::string out = Gcm({"top", "--sort", "rate"}).out;
    return out.starts_with("robot/arm\tactive\t") && out.find("robot/arm\tactive\t-") != 0;
  }));
  EXPECT_EQ(Gcm({"top", "--filter", "nobody"}).out, "");
}

TEST_F(ScreenTest, TopOnATerminalIsSortedAndFilteredByKeys) {
  Terminal terminal(
      Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " top --sort name", {},
      100);
  ASSERT_TRUE(terminal.Shows("RATE/Hz")) << terminal.seen();
  ASSERT_TRUE(terminal.Shows("desk/supervisor")) << terminal.seen();

  terminal.Type("r");
  EXPECT_TRUE(terminal.Shows("by rate")) << terminal.seen();
  terminal.Type("/host\r");
  EXPECT_TRUE(terminal.Shows("1 task, by rate, with 'host'")) << terminal.seen();
  terminal.Type("q");

  EXPECT_EQ(terminal.program().Wait(), program::kOk);
  EXPECT_TRUE(terminal.Shows("\x1b[?1049l"));  // the screen is restored
}

TEST_F(ScreenTest, TopShowsConnectionsByAKey) {
  Terminal terminal(Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " top", {},
                    160);
  ASSERT_TRUE(terminal.Shows("by load")) << terminal.seen();

  terminal.Type("c");
  EXPECT_TRUE(terminal.Shows("1 connection, by rate")) << terminal.seen();
  EXPECT_TRUE(terminal.Shows("ROUND-TRIP/ms")) << terminal.seen();
  EXPECT_TRUE(terminal.Shows("desk/supervisor/Robot")) << terminal.seen();
  terminal.Type("w");
  EXPECT_TRUE(terminal.Shows("by waiting")) << terminal.seen();
  terminal.Type("c");
  EXPECT_TRUE(terminal.Shows("by load")) << terminal.seen();
  terminal.Type("q");

  EXPECT_EQ(terminal.program().Wait(), program::kOk);
}

TEST_F(ScreenTest, TopPrintsTheCountersOfConnections) {
  const Outcome connected = Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"});
  ASSERT_EQ(connected.exit_code, program::kOk) << connected.err;
  json connection;
  EXPECT_TRUE(EventuallyTrue([&] {
    const json all = json::parse(Gcm({"top", "--connections", "--json"}).out, nullptr, false);
    if (!all.is_object() || all.value("connections", json::array()).empty()) return false;
    connection = all["connections"][0];
    // The other connection has few calls.
    return connection["required"] == "desk/teleoperation/Robot" &&
           connection.contains("round_trip_s") && connection.value("rate_hz", 0.0) > 0.0;
  })) << connection;
  EXPECT_TRUE(connection.contains("lost") && connection.contains("waiting")) << connection;

  EXPECT_THAT(Gcm({"top", "--connections"}).out,
              HasSubstr("desk/supervisor/Robot\trobot/arm/Control\tactive\t"));
  EXPECT_EQ(Gcm({"top", "--connections", "--filter", "nobody"}).out, "");
  EXPECT_EQ(Gcm({"top", "--sort", "waiting"}).err,
            "gcm: --sort waiting is for --connections, not for tasks\n");
  EXPECT_EQ(Gcm({"top", "--connections", "--sort", "load"}).exit_code, program::kUsage);
}

TEST_F(ScreenTest, TopShowsItsKeysAfterAResize) {
  Terminal terminal(Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout + " top", {},
                    100);
  ASSERT_TRUE(terminal.Shows("RATE/Hz")) << terminal.seen();
  ASSERT_TRUE(terminal.Shows("q end")) << terminal.seen();

  // Room for the processes and the sort order of the tasks, but for no task.
  terminal.Resize(7, 100);
  terminal.Type("n");
  ASSERT_TRUE(terminal.Shows("by name")) << terminal.seen();
  terminal.Type("r");
  ASSERT_TRUE(terminal.Shows("by rate")) << terminal.seen();
  ASSERT_TRUE(terminal.Shows("q end")) << terminal.seen();
  EXPECT_THAT(terminal.seen(), testing::Not(HasSubstr("teleoperation")));

  terminal.Type("q");
  EXPECT_EQ(terminal.program().Wait(), program::kOk);
}

/// Runs gcm in an interactive shell, because Ctrl-Z returns to the shell.
TEST_F(ScreenTest, CtrlZRestoresTheScreenUntilResumed) {
  const std::string gcm_line = Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout;
  Terminal terminal("/bin/bash --norc --noprofile -i", {{"PS1", "at rest> "}}, 100);
  ASSERT_TRUE(terminal.Shows("at rest> "));
  for (const std::string& verb :
       {std::string("top --sort name"), std::string("plot robot/arm/state.Joints.position[0]")}) {
    terminal.Type(gcm_line + " " + verb + "\r");
    ASSERT_TRUE(terminal.Shows("\x1b[?1049h")) << terminal.seen();
    ASSERT_TRUE(terminal.Shows("\x1b[J")) << terminal.seen();

    terminal.Type("\x1a");
    ASSERT_TRUE(terminal.Shows("\x1b[?1049l")) << terminal.seen();
    ASSERT_TRUE(terminal.Shows("at rest> ")) << terminal.seen();
    terminal.Type("fg\r");
    ASSERT_TRUE(terminal.Shows("\x1b[?1049h")) << terminal.seen();
    ASSERT_TRUE(terminal.Shows("\x1b[J")) << terminal.seen();
    terminal.Type("q");

    ASSERT_TRUE(terminal.Shows("\x1b[?1049l")) << terminal.seen();
    ASSERT_TRUE(terminal.Shows("at rest> ")) << terminal.seen();
  }
  terminal.Type("exit\r");
}

TEST_F(ScreenTest, PlotDrawsACurveWithItsScale) {
  const Outcome plotted =
      Gcm({"plot", "robot/arm/state.Joints.position[0]", "--window", "1s", "--for", "3s"});

  EXPECT_EQ(plotted.exit_code, program::kOk) << plotted.err;
  EXPECT_THAT(plotted.out, testing::StartsWith("robot/arm/state.Joints.position[0] = "));
  EXPECT_THAT(plotted.out, HasSubstr(" rad\n"));
  EXPECT_THAT(plotted.out, HasSubstr("-1 s"));
  EXPECT_EQ(std::count(plotted.out.begin(), plotted.out.end(), '\n'), 20);

  const Outcome none = Gcm({"plot", "robot/arm/state.Joints.positon"});
  EXPECT_EQ(none.exit_code, program::kNotFound) << none.out;
}

TEST_F(ScreenTest, PlotDrawsTheNumbersOfSeveralTables) {
  const Outcome plotted = Gcm({"plot", "robot/arm/state.Joints.position[0]",
                               "*/host_monitor/state.Cycle", "--window", "1s", "--for", "3s"});

  EXPECT_EQ(plotted.exit_code, program::kOk) << plotted.err;
  for (const char* title :
       {"robot/arm/state.Joints.position[0] = ", "robot/host_monitor/state.Cycle.period = ",
        "robot/host_monitor/state.Cycle.overruns = "}) {
    EXPECT_NE(plotted.out.find(title), std::string::npos) << title;
  }
}

TEST_F(ScreenTest, PlotOnATerminalEndsWithAKeyOrAnInterrupt) {
  for (const char* key : {"q", "\x03"}) {
    Terminal terminal(Binary("gcm") + " --gcm " + address + " --timeout " + kTestTimeout +
                      " plot robot/arm/state.Joints.position[0]");
    ASSERT_TRUE(terminal.Shows(" rad")) << terminal.seen();

    terminal.Type(key);

    const bool is_interrupt = key[0] == '\x03';
    EXPECT_EQ(terminal.program().Wait(), is_interrupt ? program::kInterrupted : program::kOk);
  }
}

TEST_F(ScreenTest, TheDoctorReportsHealthAndFixes) {
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code,
            program::kOk);
  Outcome well;
  EXPECT_TRUE(EventuallyTrue([&] {  // clock offsets are known later than the other values
    well = Gcm({"doctor"});
    return well.exit_code == program::kOk && well.out.find("clock 0.0 ms off") != well.out.npos;
  })) << well.out;
  EXPECT_THAT(well.out, HasSubstr("ok   process robot  "));
  EXPECT_THAT(well.out, testing::ContainsRegex("ok   plug-in robot simulated_arm +.*\\.so of 20"));
  EXPECT_THAT(well.out, HasSubstr("connections"));

  robot->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\tlost"));
  const Outcome ill = Gcm({"doctor"});
  EXPECT_EQ(ill.exit_code, program::kRefused);
  EXPECT_THAT(ill.out, HasSubstr("BAD  process robot"));
  // If the GCM has missed its lease first, the process may also hang.
  EXPECT_THAT(ill.out, testing::AnyOf(HasSubstr("or, to remove it from the list: gcm forget robot"),
                                      HasSubstr("to end the process: kill -9 ")));
  EXPECT_THAT(ill.out, HasSubstr("fix: gcm explain desk/supervisor/Robot"));
}

TEST_F(SystemFixture, TheDoctorExplainsHowToStartAGcm) {
  const Outcome outcome =
      RunProgram({Binary("gcm"), "--gcm", address, "--timeout", "50", "doctor"});

  EXPECT_EQ(outcome.exit_code, program::kRefused);
  EXPECT_THAT(outcome.out, HasSubstr("BAD  GCM"));
  EXPECT_THAT(outcome.out, HasSubstr("fix: start a GCM with gcm serve"));
  EXPECT_THAT(outcome.out,
              HasSubstr("ok   port    " + address + " is free: no program listens there"));
}

TEST_F(SystemFixture, TheDoctorNamesTheHolderOfTheGcmPort) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(std::stoi(port)));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(bind(listener, reinterpret_cast<const sockaddr*>(&place), sizeof(place)), 0);
  ASSERT_EQ(listen(listener, 5), 0);

  const Outcome outcome =
      RunProgram({Binary("gcm"), "--gcm", address, "--timeout", "50", "doctor"});

  EXPECT_EQ(outcome.exit_code, program::kRefused);
  EXPECT_THAT(outcome.out, HasSubstr("BAD  port    " + address + " is used by pid " +
                                     std::to_string(getpid()) + " ("));
  close(listener);
}

}  // namespace
