#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "system/faults/harness/fault_test.h"
#include "system/faults/harness/motion_checker.h"
#include "system/faults/instruments/jogger.h"

// Tests transitions between two safe states of a moving system.

namespace faults {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr arm::JointVector kHome{0.0, -0.785398, 0.0, -2.356194, 0.0, 1.570796, 0.785398};
constexpr arm::JointVector kElsewhere{1.5, 0.3, -0.5, -1.2, 0.4, 2.4, -1.0};

/// Process robot has two arms in different postures. Process desk has a teleoperation, and a hand
/// that turns a joint; both are not connected yet.
class Transitions : public FaultTest {
 protected:
  void StartArms() {
    more_environment_["TENDON_COMPONENTS"] =
        Built("components") + ":" + Built("tests/system/faults/instruments");
    const json arm = {{"class", "SimulatedArm"}, {"library", "simulated_arm"}};
    json first = arm;
    first["name"] = "arm";
    json second = arm;
    second["name"] = "arm2";
    second["configuration"] = {{"home", kElsewhere}};
    const json leader = {
        {"name", "teleoperation"}, {"class", "Teleoperation"}, {"library", "teleoperation"}};
    const json hand = {{"name", "hand"}, {"class", "Jogger"}, {"library", "fault_instruments"}};
    const json system = {{"version", 1},
                         {"name", "arms"},
                         {"processes",
                          {{{"name", "robot"}, {"components", {first, second}}},
                           {{"name", "desk"}, {"components", {leader, hand}}}}}};
    home_.Write("system.json", system.dump());
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_NO_FATAL_FAILURE(StartViewer());
    robot_ = MakeLcm("robot");
    desk_ = MakeLcm("desk");
    ASSERT_TRUE(EventuallyActive("robot", "arm2")) << robot_->err();
    ASSERT_TRUE(EventuallyActive("desk", "hand")) << desk_->err();
    viewer_->telemetry().Subscribe({"robot", "arm", "state", {"Joints"}}, arm_);
    viewer_->telemetry().Subscribe({"robot", "arm2", "state", {"Joints"}}, arm2_);
    ASSERT_TRUE(Eventually([&] { return arm_->rows() > 0 && arm2_->rows() > 0; }));
  }
  void Do(const Words& words) const {
    const Outcome done = Gcm(words);
    ASSERT_EQ(done.exit_code, 0) << done.out << done.err;
  }
  void Lead(const std::string& name) {
    Do({"connect", "desk/teleoperation/Robot", "robot/" + name + "/Control", "--replace"});
  }
  /// Waits until all rows of a suspended arm have arrived.
  static bool EventuallyStandsStill(const MotionChecker& one) {
    constexpr int kLooks = 40;  // together longer than rows wait for their batch
    int same = 0;
    std::size_t rows = one.rows();
    return Eventually([&] {
      same = rows == one.rows() ? same + 1 : 0;
      rows = one.rows();
      return same >= kLooks;
    });
  }
  static bool EventuallyRests(const MotionChecker& one) {
    return Eventually([&] { return one.speed() < 1e-3; });
  }
  static constexpr double kMoving = 0.05;  // rad/s; the tour of a teleoperation never rests
  static bool EventuallyMoves(const MotionChecker& one) {
    return Eventually([&] { return one.speed() > kMoving; });
  }
  /// Returns the peak during `cycles` further cycles of the arm.
  static Peak PeakWithin(MotionChecker& one, std::size_t cycles) {
    const std::size_t rows = one.rows();
    EXPECT_TRUE(Eventually([&] { return one.rows() >= rows + cycles; }));
    return one.TakePeak();
  }
  /// Returns the peak from rest until the arm has been led for 2 s.
  static Peak PeakLed(MotionChecker& one) {
    EXPECT_TRUE(EventuallyMoves(one));
    return PeakWithin(one, 2000);
  }
  /// Moves an arm without a leader to a posture, where it rests.
  void Place(const std::string& name, MotionChecker& one, const arm::JointVector& posture) {
    const json goal = {{"position", posture}, {"duration", 1.0}};
    Do({"call", "robot/" + name + "/Control.MoveTo", goal.dump()});
    const auto is_there = [&] {
      const auto joints = one.joints();
      double furthest = 0.0;
      for (std::size_t joint = 0; joint < arm::kJoints; ++joint) {
        furthest = std::max(furthest, std::abs(joints.position[joint] - posture[joint]));
      }
      return furthest < 2e-3;
    };
    EXPECT_TRUE(Eventually(is_there));
    EXPECT_TRUE(EventuallyRests(one));
    (void)one.TakePeak();
  }
  /// Returns the peak of an arm that is led from rest at `posture`.
  Peak GentleFrom(const std::string& name, MotionChecker& one, const arm::JointVector& posture) {
    Do({"disconnect", "desk/teleoperation/Robot"});
    EXPECT_TRUE(EventuallyRests(one));
    Place(name, one, posture);
    Lead(name);
    return PeakLed(one);
  }
  /// Returns true if another round is needed: fewer than `rounds` were made, or the machine stalled
  /// in all rounds.
  bool GoesOn(int round, int rounds) const {
    constexpr int kMaxRounds = 5;
    return round < rounds || (judged_ == 0 && round < kMaxRounds);
  }
  void ExpectNoLeap(const std::string& what, const Peak& peak, const Peak& gentle) {
    // On an overloaded machine, the cycles of the arm are late: it falls behind its leader, then
    // catches up. The leader is late as well, so its goals jump. Such rounds are not judged.
    constexpr double kCalm = 0.004;   // s
    constexpr double kStall = 0.020;  // s
    const double stall = std::max(peak.stall, gentle.stall);
    const bool is_judged = stall < kStall;
    Tell(what + ": " + ToString(peak) + "; from rest " + ToString(gentle) +
         (is_judged ? "" : "; the machine stood still: not judged"));
    is_judge_ = true;
    if (!is_judged) return;
    ++judged_;
    const double margin = stall < kCalm ? 1.2 : 2.5;
    EXPECT_GT(peak.speed, kMoving) << what;
    EXPECT_LE(peak.speed, margin * gentle.speed) << what;
    EXPECT_LE(peak.acceleration, margin * gentle.acceleration) << what;
  }

  void TearDown() override {
    if (is_judge_ && judged_ == 0) GTEST_SKIP() << "the machine stood still in every round";
  }

  bool is_judge_ = false;
  int judged_ = 0;
  const std::shared_ptr<MotionChecker> arm_ = std::make_shared<MotionChecker>();
  const std::shared_ptr<MotionChecker> arm2_ = std::make_shared<MotionChecker>();
};

/// Returns one middleware; if the faults have their full size, all middlewares.
std::vector<std::string> SomeMiddlewares() {
  auto all = Middlewares();
  all.resize(static_cast<std::size_t>(Size(1, static_cast<int>(all.size()))));
  return all;
}

INSTANTIATE_TEST_SUITE_P(Over, Transitions, testing::ValuesIn(SomeMiddlewares()), NameOfMiddleware);

TEST_P(Transitions, AnotherArmIsDrivenFromItsPosition) {
  ASSERT_NO_FATAL_FAILURE(StartArms());
  const int rounds = Size(1, 30);
  for (int round = 0; GoesOn(round, rounds); ++round) {
    SCOPED_TRACE(round);
    ASSERT_NO_FATAL_FAILURE(Lead("arm2"));
    (void)PeakLed(*arm2_);
    (void)arm_->TakePeak();

    ASSERT_NO_FATAL_FAILURE(Lead("arm"));
    const Peak by_replace = PeakLed(*arm_);
    EXPECT_TRUE(EventuallyRests(*arm2_)) << "the one that is left behind";
    const arm::JointVector left_at = arm2_->joints().position;
    (void)arm2_->TakePeak();
    ASSERT_NO_FATAL_FAILURE(Do({"undo"}));
    const Peak by_undo = PeakLed(*arm2_);

    ExpectNoLeap("undo", by_undo, GentleFrom("arm2", *arm2_, left_at));
    ExpectNoLeap("replace", by_replace, GentleFrom("arm", *arm_, kHome));
    ASSERT_NO_FATAL_FAILURE(Do({"disconnect", "desk/teleoperation/Robot"}));
    Place("arm", *arm_, kHome);
    Place("arm2", *arm2_, kElsewhere);
  }
}

TEST_P(Transitions, ARestartedArmIsDrivenFromItsPosition) {
  ASSERT_NO_FATAL_FAILURE(StartArms());
  ASSERT_NO_FATAL_FAILURE(Lead("arm"));
  for (int round = 0; GoesOn(round, 1); ++round) {
    SCOPED_TRACE(round);
    (void)PeakLed(*arm_);

    robot_->Signal(SIGKILL);
    robot_->Wait();
    const std::size_t rows = arm_->rows();
    (void)arm_->TakePeak();
    robot_ = MakeLcm("robot");
    ASSERT_TRUE(Eventually([&] { return arm_->rows() > rows; })) << robot_->err();
    const Peak anew = PeakLed(*arm_);

    ExpectNoLeap("a new epoch", anew, GentleFrom("arm", *arm_, kHome));
  }
}

TEST_P(Transitions, AResumedClientStartsFromTheCurrentPosition) {
  ASSERT_NO_FATAL_FAILURE(StartArms());
  for (int round = 0; GoesOn(round, Size(1, 30)); ++round) {
    SCOPED_TRACE(round);
    ASSERT_NO_FATAL_FAILURE(Lead("arm"));
    (void)PeakLed(*arm_);

    ASSERT_NO_FATAL_FAILURE(Do({"suspend", "desk/teleoperation"}));
    Place("arm", *arm_, kElsewhere);
    ASSERT_NO_FATAL_FAILURE(Do({"start", "desk/teleoperation"}));
    const Peak resumed = PeakLed(*arm_);

    ExpectNoLeap("resumed", resumed, GentleFrom("arm", *arm_, kElsewhere));
    ASSERT_NO_FATAL_FAILURE(Do({"disconnect", "desk/teleoperation/Robot"}));
    Place("arm", *arm_, kHome);
  }
}

TEST_P(Transitions, AResumedServerDoesNotContinueToItsOldGoal) {
  ASSERT_NO_FATAL_FAILURE(StartArms());
  // Longer than the programs need that suspend the arm during the motion.
  const json goal = {{"position", kElsewhere}, {"duration", 20.0}};
  ASSERT_NO_FATAL_FAILURE(Do({"call", "robot/arm/Control.MoveTo", goal.dump()}));
  ASSERT_TRUE(EventuallyMoves(*arm_));
  ASSERT_NO_FATAL_FAILURE(Do({"suspend", "robot/arm"}));
  ASSERT_TRUE(EventuallyStandsStill(*arm_));
  const std::size_t rows = arm_->rows();

  ASSERT_NO_FATAL_FAILURE(Do({"start", "robot/arm"}));
  ASSERT_TRUE(Eventually([&] { return arm_->rows() > rows + 100; }));
  const arm::JointVector held = arm_->joints().position;
  (void)PeakWithin(*arm_, 100);
  const Peak later = PeakWithin(*arm_, 3000);

  EXPECT_EQ(arm_->joints().position, held);
  EXPECT_EQ(later.speed, 0.0);
  EXPECT_THAT(robot_->err(), HasSubstr("holds its position"));
}

TEST_P(Transitions, AResumedServerIsDrivenFromItsPosition) {
  ASSERT_NO_FATAL_FAILURE(StartArms());
  ASSERT_NO_FATAL_FAILURE(Lead("arm"));
  for (int round = 0; GoesOn(round, 1); ++round) {
    SCOPED_TRACE(round);
    (void)PeakLed(*arm_);
    ASSERT_NO_FATAL_FAILURE(Do({"suspend", "robot/arm"}));
    ASSERT_TRUE(EventuallyStandsStill(*arm_));
    const std::size_t rows = arm_->rows();

    ASSERT_NO_FATAL_FAILURE(Do({"start", "robot/arm"}));
    ASSERT_TRUE(Eventually([&] { return arm_->rows() > rows; }));
    const arm::JointVector stood = arm_->joints().position;
    (void)arm_->TakePeak();
    const Peak resumed = PeakLed(*arm_);

    ExpectNoLeap("resumed", resumed, GentleFrom("arm", *arm_, stood));
  }
}

TEST_P(Transitions, AnArmComesToRestWhenItsClientIsKilledOrHangs) {
  ASSERT_NO_FATAL_FAILURE(StartArms());
  ASSERT_NO_FATAL_FAILURE(Do({"connect", "desk/hand/Robot", "robot/arm/Control"}));
  long longest = 0;  // ms in motion after the fault
  for (int round = 0; round < Size(2, 30); ++round) {
    SCOPED_TRACE(round);
    const bool kills = round % 2 == 0;
    ASSERT_TRUE(EventuallyMoves(*arm_)) << "the GCM gives the hand its connection back";

    const tendon::SteadyTime at = tendon::SteadyClock().Now();
    desk_->Signal(kills ? SIGKILL : SIGSTOP);
    EXPECT_TRUE(EventuallyRests(*arm_));
    longest = std::max(
        longest,
        std::chrono::duration_cast<std::chrono::milliseconds>(arm_->last_motion() - at).count());
    if (!kills) desk_->Signal(SIGCONT);
    desk_->Signal(SIGKILL);
    desk_->Wait();
    ASSERT_TRUE(EventuallyIs("desk", tendon::ProcessState::kLost));
    Place("arm", *arm_, kHome);
    desk_ = MakeLcm("desk");
    ASSERT_TRUE(EventuallyIs("desk", tendon::ProcessState::kAlive)) << desk_->err();
    ASSERT_TRUE(EventuallyActive("desk", "hand")) << desk_->err();
  }

  Tell("in motion for at most " + std::to_string(longest) + " ms");
  if (!MayExpireLeases()) {
    EXPECT_LT(static_cast<double>(longest), 700.0 * Slowness()) << "the lease takes 1500 ms";
  }
}

}  // namespace
}  // namespace faults
