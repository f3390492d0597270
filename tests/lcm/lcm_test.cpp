#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <program/exit_code.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <tendon/process/version_messages.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "gcm_console/system_fixture.h"
#include "support/program.h"

namespace {

using testing::HasSubstr;

/// A server that accepts connections and then sends nothing.
class HangingServer {
 public:
  HangingServer() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(port_));
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof(place)), 0);
    EXPECT_EQ(listen(socket_, SOMAXCONN), 0);
    const timeval timeout{.tv_sec = 20, .tv_usec = 0};  // the time limit for a receive
    EXPECT_EQ(setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof(timeout)), 0);
  }
  HangingServer(const HangingServer&) = delete;
  HangingServer& operator=(const HangingServer&) = delete;
  ~HangingServer() { close(socket_); }

  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  void WaitForVisitor() const { EXPECT_GE(accept(socket_, nullptr, nullptr), 0); }

 private:
  const int port_ = FreePort();
  const int socket_;
};

class LcmTest : public SystemFixture {
 protected:
  std::string Write(const std::string& text) const {
    home.Write("system.json", text);
    return (home.path() / "system.json").string();
  }
  /// Runs an LCM that is expected to fail.
  Outcome Refused(const std::string& name, const std::string& system) const {
    const auto lcm = StartLcm(name, system);
    const auto exit_code = lcm->Wait();
    return {exit_code.value_or(-1), lcm->out(), lcm->err()};
  }
};

TEST_F(LcmTest, ReportsAMissingGcm) {
  const Outcome outcome = RunProgram(
      {Binary("lcm"), "--name", "robot", "--gcm", address, "--timeout", "2000", "--system", demo});

  EXPECT_EQ(outcome.exit_code, program::kUnreachable);
  EXPECT_THAT(outcome.err, HasSubstr("no GCM at " + address));
  const Outcome with_unit = RunProgram(
      {Binary("lcm"), "--name", "robot", "--gcm", address, "--timeout", "1.5s", "--system", demo});
  EXPECT_EQ(with_unit.exit_code, program::kUnreachable) << with_unit.err;
}

TEST_F(LcmTest, PrintsItsVersionAndFailsOnAFullDisk) {
  const Outcome version = RunProgram({Binary("lcm"), "--version"});
  EXPECT_EQ(version.exit_code, program::kOk);
  EXPECT_EQ(version.out, "lcm " + tendon::OwnVersion().release + "\n");

  const Outcome full = RunProgram({"/bin/sh", "-c", Binary("lcm") + " --help >/dev/full"});
  EXPECT_EQ(full.exit_code, program::kRefused);
  EXPECT_EQ(full.err, "lcm: cannot write the output: the disk is full, or the output is closed\n");
}

TEST_F(LcmTest, ASecondProcessOfOneNameIsRefusedWithTheHolder) {
  StartGcm();
  const auto first = StartLcm("robot", demo);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << first->err();

  const Outcome second = Refused("robot", demo);

  EXPECT_EQ(second.exit_code, program::kRefused);
  EXPECT_THAT(second.err, HasSubstr("'robot' is in use"));
  EXPECT_THAT(second.err, HasSubstr("pid " + std::to_string(first->pid())));
  EXPECT_EQ(std::count(second.err.begin(), second.err.end(), '\n'), 1) << second.err;
  EXPECT_TRUE(EventuallySays({"ls"}, "robot\talive"));
}

TEST_F(LcmTest, AMissingPluginPreventsJoining) {
  StartGcm();
  const std::string file = Write(R"({"version": 1, "name": "x", "processes": [{"name": "robot",
    "components": [{"name": "arm", "class": "SimulatedArm", "library": "simulated_arn"}]}]})");

  const Outcome outcome = Refused("robot", file);

  EXPECT_EQ(outcome.exit_code, program::kNotFound);
  EXPECT_THAT(outcome.err, HasSubstr("no plug-in 'simulated_arn'; did you mean 'simulated_arm'?"));
  EXPECT_THAT(Gcm({"ls"}).out, Not(HasSubstr("robot")));
}

TEST_F(LcmTest, ReportsAMissingClass) {
  StartGcm();
  const std::string file = Write(R"({"version": 1, "name": "x", "processes": [{"name": "robot",
    "components": [{"name": "arm", "class": "SimulatedArn", "library": "simulated_arm"}]}]})");

  const Outcome outcome = Refused("robot", file);

  EXPECT_EQ(outcome.exit_code, program::kNotFound);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'SimulatedArm'?"));
}

TEST_F(LcmTest, RejectsAProcessMissingInTheFile) {
  const Outcome outcome = Refused("robt", demo);

  EXPECT_EQ(outcome.exit_code, program::kNotFound);
  EXPECT_THAT(outcome.err, HasSubstr("has no process 'robt'; did you mean 'robot'?"));
}

TEST_F(LcmTest, SigtermEndsItAndItLeaves) {
  StartGcm();
  const auto lcm = StartLcm("robot", demo);
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << lcm->err();

  lcm->Signal(SIGTERM);

  EXPECT_EQ(lcm->Wait(), program::kOk) << lcm->err();
  EXPECT_TRUE(EventuallySays({"ls"}, "robot\tleft"));
}

TEST_F(LcmTest, SigtermEndsItWithLongSleepingThreads) {
  StartGcm();
  const std::string system = Write(R"({"version": 1, "name": "idle", "processes": [
      {"name": "robot", "components": [
        {"name": "arm", "class": "SimulatedArm", "library": "simulated_arm",
         "thread": {"timer_slack": 0.1}}]}]})");
  const auto lcm = StartLcm("robot", system);
  ASSERT_TRUE(EventuallySays({"ls", "robot"}, "arm\tactive")) << lcm->err();

  lcm->Signal(SIGTERM);

  EXPECT_EQ(lcm->Wait(), program::kOk) << lcm->err();
}

TEST_F(LcmTest, SigtermEndsItWhileItStartsComponents) {
  StartGcm();
  const std::string gate = (home.path() / "gate").string();
  const std::string system = Write(R"({"version": 1, "name": "slow", "processes": [
      {"name": "robot", "components": [
        {"name": "slow", "class": "SlowConfigurer", "library": "lamps",
         "configuration": {"file": ")" +
                                   gate + R"("}},
        {"name": "next", "class": "Switch", "library": "lamps"}]}]})");
  Program lcm({Binary("lcm"), "--name", "robot", "--gcm", address, "--timeout", kTestTimeout,
               "--system", system},
              {{"TENDON_COMPONENTS", Built("tests/support/built")}});
  ASSERT_TRUE(EventuallySays({"ls"}, "robot\talive")) << lcm.err();

  lcm.Signal(SIGTERM);
  home.Write("gate", "");

  EXPECT_EQ(lcm.Wait(), program::kOk) << lcm.err();
}

TEST_F(LcmTest, SigtermEndsItAtOnceWhileItSeeksTheGcm) {
  const HangingServer gcm_that_hangs;
  Program lcm(
      {Binary("lcm"), "--name", "robot", "--gcm", gcm_that_hangs.address(), "--timeout", "600000"});
  gcm_that_hangs.WaitForVisitor();

  lcm.Signal(SIGTERM);

  EXPECT_EQ(lcm.Wait(), program::kOk) << lcm.err();  // long before the time-out of ten minutes
  EXPECT_EQ(lcm.err(), "");
}

TEST_F(LcmTest, AHangingGcmIsUnreachable) {
  const HangingServer gcm_that_hangs;

  const Outcome outcome = RunProgram(
      {Binary("lcm"), "--name", "robot", "--gcm", gcm_that_hangs.address(), "--timeout", "200"});

  EXPECT_EQ(outcome.exit_code, program::kUnreachable);
  EXPECT_THAT(outcome.err, HasSubstr("GCM at " + gcm_that_hangs.address()));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST_F(LcmTest, ARestartedProcessGetsItsConnectionsBack) {
  StartGcm();
  const auto robot = StartLcm("robot", demo);
  auto desk = StartLcm("desk", demo);
  ASSERT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n")) << desk->err();
  ASSERT_EQ(Gcm({"connect", "desk/teleoperation/Robot", "robot/arm/Control"}).exit_code, 0);
  desk->Signal(SIGKILL);
  ASSERT_TRUE(EventuallySays({"ls"}, "desk\tlost"));

  desk = StartLcm("desk", demo);

  EXPECT_TRUE(EventuallySays({"ls", "desk/teleoperation"}, "-> robot/arm/Control\n"));
  EXPECT_TRUE(EventuallySays({"ls", "desk/supervisor"}, "-> robot/arm/Control\n"));
  EXPECT_TRUE(EventuallyTrue([&] { return desk->err().find("runs 3") != std::string::npos; }));
  EXPECT_THAT(desk->err(), Not(HasSubstr("not connected")));
}

}  // namespace
