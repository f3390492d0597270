#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

using nlohmann::json;

/// The sending rate of the driver, and the load of the drive.
struct Load {
  double cycle = 0.0;  // s
  bool floods = false;
};

/// Process cab has a driver. The driver moves the drive of process garage, and stops the drive at
/// its own end.
class OrderlyEnd : public FaultTest {
 protected:
  /// Ends the processes that the GCM has started; otherwise they would continue.
  void TearDown() override {
    if (gcm_starts_) (void)Gcm({"kill", "*", "--yes"});
  }
  /// Starts a GCM without processes. With a `start`, the GCM starts the processes of the file.
  void StartGcmFor(const Load& load, const std::string& start = {}) {
    gcm_starts_ = !start.empty();
    const std::string folder = home_.path() / "journals";
    const auto component = [&](const std::string& name, const std::string& class_name) {
      const json settings = {{"folder", folder}, {"cycle", load.cycle}, {"floods", load.floods}};
      return R"([{"name": ")" + name + R"(", "class": ")" + class_name +
             R"(", "library": "fault_instruments", "configuration": )" + settings.dump() + "}]";
    };
    home_.Write("system.json", R"({"version": 1, "name": "drives", "processes": [
        {"name": "garage", )" + start +
                                   R"("components": )" + component("drive", "Drive") + R"(},
        {"name": "cab", )" + start +
                                   R"("components": )" + component("driver", "Driver") + R"(}],
        "connections": [{"required": "cab/driver/Drive", "provided": "garage/drive/Control"}]})");
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_NO_FATAL_FAILURE(StartViewer());
  }
  void StartGarage() {
    robot_ = MakeLcm("garage");
    ASSERT_TRUE(EventuallyActive("garage", "drive")) << robot_->err();
  }
  /// Starts cab, and returns when the drive moves.
  void StartCab() {
    const std::size_t moved = Lines("moved");
    desk_ = MakeLcm("cab");
    ASSERT_TRUE(Eventually([&] { return Lines("moved") > moved; })) << desk_->err();
  }
  /// Expects that exactly `count` drivers have ended, and that their stops were executed.
  void ExpectStops(int count) const {
    EXPECT_EQ(Lines("ended", "queued"), static_cast<std::size_t>(count));
    EXPECT_EQ(Lines("ended"), static_cast<std::size_t>(count));
    EXPECT_EQ(Lines("stopped"), static_cast<std::size_t>(count));
  }
  void Do(const Words& words) const {
    const Outcome done = Gcm(words);
    ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
  }

 private:
  bool gcm_starts_ = false;
};

INSTANTIATE_TEST_SUITE_P(Over, OrderlyEnd, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(OrderlyEnd, ASignalExecutesTheLastStop) {
  const int rounds = Size(3, 30);
  long longest = 0;  // ms
  ASSERT_NO_FATAL_FAILURE(StartGcmFor({}));
  ASSERT_NO_FATAL_FAILURE(StartGarage());

  for (int round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    ASSERT_NO_FATAL_FAILURE(StartCab());
    const Stopwatch since_told;
    desk_->Signal(round % 2 == 0 ? SIGINT : SIGTERM);
    EXPECT_EQ(desk_->Wait(), 0) << desk_->err();
    longest = std::max(longest, since_told.milliseconds());
    ExpectStops(round);
  }

  Tell(std::to_string(rounds) + " ends, the longest took " + std::to_string(longest) + " ms");
}

TEST_P(OrderlyEnd, ExecutesTheLastStopDespiteAFullQueue) {
  const int rounds = Size(3, 30);
  ASSERT_NO_FATAL_FAILURE(StartGcmFor({.cycle = 0.03, .floods = true}));
  ASSERT_NO_FATAL_FAILURE(StartGarage());

  for (int round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    ASSERT_NO_FATAL_FAILURE(StartCab());
    desk_->Signal(round % 2 == 0 ? SIGINT : SIGTERM);
    EXPECT_EQ(desk_->Wait(), 0) << desk_->err();
    ExpectStops(round);
  }
}

TEST_P(OrderlyEnd, AStopCommandExecutesTheLastStop) {
  const int rounds = Size(2, 30);
  int stops = 0;
  ASSERT_NO_FATAL_FAILURE(StartGcmFor({.cycle = 0.005, .floods = true}));
  ASSERT_NO_FATAL_FAILURE(StartGarage());

  for (int round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    ASSERT_NO_FATAL_FAILURE(StartCab());
    ASSERT_NO_FATAL_FAILURE(Do({"restart", "cab/driver"}));
    ExpectStops(++stops);
    ASSERT_NO_FATAL_FAILURE(Do({"stop", "cab/driver"}));
    ExpectStops(++stops);
    const auto moves_again = [this, moved = Lines("moved")] { return Lines("moved") > moved; };
    ASSERT_NO_FATAL_FAILURE(Do({"start", "cab/driver"}));
    ASSERT_TRUE(Eventually(moves_again));
    ASSERT_NO_FATAL_FAILURE(Do({"rm", "cab/driver"}));
    ExpectStops(++stops);
    desk_->Signal(SIGTERM);
    EXPECT_EQ(desk_->Wait(), 0) << desk_->err();
  }
}

/// Clients end first, whatever the order of their names.
TEST_P(OrderlyEnd, TheGcmEndsClientProcessesFirst) {
  const int rounds = Size(2, 30);
  ASSERT_NO_FATAL_FAILURE(StartGcmFor({}, R"("start": {}, )"));

  for (int round = 1; round <= rounds; ++round) {
    SCOPED_TRACE(round);
    const auto moves = [this, moved = Lines("moved")] { return Lines("moved") > moved; };
    ASSERT_NO_FATAL_FAILURE(Do({"apply", home_.path() / "system.json"}));
    ASSERT_TRUE(Eventually(moves));
    ASSERT_NO_FATAL_FAILURE(Do({"kill", "garage", "cab"}));
    ExpectStops(round);
  }
}

/// One command stops all components.
TEST_P(OrderlyEnd, StoppingAllStopsClientComponentsFirst) {
  ASSERT_NO_FATAL_FAILURE(StartGcmFor({.cycle = 0.005, .floods = true}));
  ASSERT_NO_FATAL_FAILURE(StartGarage());
  ASSERT_NO_FATAL_FAILURE(StartCab());

  ASSERT_NO_FATAL_FAILURE(Do({"stop", "garage/drive", "cab/driver"}));

  ExpectStops(1);
}

/// The peer and the GCM hang.
TEST_P(OrderlyEnd, AnLcmDoesNotWaitLongForHangingPeers) {
  ASSERT_NO_FATAL_FAILURE(StartGcmFor({.cycle = 0.0, .floods = true}));
  ASSERT_NO_FATAL_FAILURE(StartGarage());
  ASSERT_NO_FATAL_FAILURE(StartCab());
  robot_->Signal(SIGSTOP);
  gcm_->Signal(SIGSTOP);

  const Stopwatch since_told;
  desk_->Signal(SIGTERM);
  EXPECT_EQ(desk_->Wait(), 0);
  const long took = since_told.milliseconds();

  Tell("it took " + std::to_string(took) + " ms");
  robot_->Signal(SIGCONT);
  gcm_->Signal(SIGCONT);
  EXPECT_EQ(Lines("ended"), 1U);
  if (MayExpireLeases()) return;
  EXPECT_LT(static_cast<double>(took), 2000.0 * Slowness());
}

/// Uses the components of Tendon. Goals of the teleoperation last 0.4 s; a stop is shorter.
TEST_P(OrderlyEnd, EndingTheTeleoperationLeavesTheArmAtRest) {
  home_.Write("system.json", R"({"version": 1, "name": "arms", "processes": [
      {"name": "robot", "components": [
        {"name": "arm", "class": "SimulatedArm", "library": "simulated_arm"}]},
      {"name": "desk", "components": [
        {"name": "teleoperation", "class": "Teleoperation", "library": "teleoperation"}]}],
      "connections": [
        {"required": "desk/teleoperation/Robot", "provided": "robot/arm/Control"}]})");
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  robot_ = MakeLcm("robot");
  ASSERT_TRUE(EventuallyActive("robot", "arm")) << robot_->err();
  const auto read = [this](const std::string& column) {
    const Outcome called = Gcm({"call", "robot/arm/state." + column});
    EXPECT_EQ(called.exit_code, 0) << called.err;
    return json::parse(called.out, nullptr, false);
  };
  const auto speed = [&] {
    double fastest = 0.0;  // rad/s
    const json joints = read("Joints");
    for (const double one : joints.at("velocity")) {
      fastest = std::max(fastest, std::abs(one));
    }
    return fastest;
  };

  for (int round = 1; round <= Size(2, 30); ++round) {
    SCOPED_TRACE(round);
    desk_ = MakeLcm("desk");
    ASSERT_TRUE(Eventually([&] { return speed() > 0.05; })) << desk_->err();
    desk_->Signal(round % 2 == 0 ? SIGINT : SIGTERM);
    EXPECT_EQ(desk_->Wait(), 0) << desk_->err();

    EXPECT_LT(read("Goal").at("duration").get<double>(), 0.4);
    EXPECT_TRUE(Eventually([&] { return speed() < 1e-3; }));
  }
}

}  // namespace
}  // namespace faults
