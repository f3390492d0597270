#include <components/simulated_arm/simulated_arm.h>
#include <components/teleoperation/teleoperation.h>
#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <support/refusal.h>
#include <support/wait.h>
#include <tendon/manager/local_manager.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "components/arm_client.h"
#include "components/stepped.h"

namespace arm {
namespace {

using tendon::AllocationGuard;
using tendon_test::Stepped;

constexpr int kArmCycles = 20;  // cycles of the arm per cycle of the teleoperation

double FastestOf(const JointVector& velocities) {
  double fastest = 0.0;
  for (const double velocity : velocities) fastest = std::max(fastest, std::abs(velocity));
  return fastest;
}

/// Both components run in the test's thread, and their time advances together. They are not
/// connected at first.
class SteppedPair {
 public:
  explicit SteppedPair(const ArmConfiguration& arm_configuration = {},
                       const TeleoperationConfiguration& configuration = {})
      : arm(manager.Add<Stepped<SimulatedArm>>("arm", arm_configuration)),
        teleoperation(manager.Add<Stepped<Teleoperation>>("teleoperation", configuration)) {
    EXPECT_TRUE(manager.StartAll());
  }

  void Connect() { EXPECT_TRUE(manager.Connect({"teleoperation", "Robot"}, {"arm", "Control"})); }
  /// Calls `look()` after each cycle of the teleoperation.
  template <typename Look>
  void Run(double seconds, Look look) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 50.0)); ++i) {
      arm.Cycle(kArmCycles);
      teleoperation.Cycle();
      look();
    }
  }
  void Run(double seconds) {
    Run(seconds, [] {});
  }

  JointVector position() { return arm.Read<JointState>("Joints").position; }
  double speed() { return FastestOf(arm.Read<JointState>("Joints").velocity); }
  double worst() { return teleoperation.Read<Tracking>("Tracking").worst; }
  std::uint64_t limits() { return teleoperation.Read<std::uint64_t>("Limits"); }

  tendon::LocalManager manager;
  Stepped<SimulatedArm>& arm;
  Stepped<Teleoperation>& teleoperation;
};

TEST(Teleoperation, DoesNothingUntilItIsConnected) {
  SteppedPair pair;

  pair.Run(3.0);

  EXPECT_EQ(pair.position(), kReadyPosture);
  EXPECT_EQ(pair.teleoperation.Read<Target>("Target").position, JointVector{});
  EXPECT_EQ(pair.worst(), 0.0);
}

TEST(Teleoperation, StartsFromThePositionOfTheArm) {
  SteppedPair pair;
  pair.Run(1.0);
  pair.Connect();

  pair.Run(0.02);

  const JointVector target = pair.teleoperation.Read<Target>("Target").position;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    EXPECT_NEAR(target[joint], kReadyPosture[joint], 1e-9) << joint;
  }
}

/// Two arms in different postures. The teleoperation leads one of them at a time.
class SteppedTrio : public SteppedPair {
 public:
  explicit SteppedTrio(const ArmConfiguration& configuration = {})
      : SteppedPair(configuration),
        other(manager.Add<Stepped<SimulatedArm>>("other", Elsewhere())) {
    EXPECT_TRUE(manager.Start("other"));
    arm.Cycle();
    other.Cycle();
  }

  /// The greatest speed (rad/s) and acceleration (rad/s^2) of any joint of either arm. The led arm
  /// still moves at the end, because the tour never rests.
  struct Peak {
    double speed = 0.0;
    double acceleration = 0.0;
  };
  Peak PeakWithin(double seconds) {
    Peak peak;
    std::array<JointVector, 2> speeds{arm.Read<JointState>("Joints").velocity,
                                      other.Read<JointState>("Joints").velocity};
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 50.0)); ++i) {
      for (int cycle = 0; cycle < kArmCycles; ++cycle) {
        Step(arm, speeds[0], peak);
        Step(other, speeds[1], peak);
      }
      teleoperation.Cycle();
    }
    EXPECT_GT(FastestOf(led_->Read<JointState>("Joints").velocity), kMoving);
    return peak;
  }
  void Lead(const char* name) {
    (void)manager.Disconnect({"teleoperation", "Robot"});
    EXPECT_TRUE(manager.Connect({"teleoperation", "Robot"}, {name, "Control"}));
    led_ = name == other.name() ? &other : &arm;
  }

  Stepped<SimulatedArm>& other;

 private:
  static ArmConfiguration Elsewhere() {
    ArmConfiguration configuration;
    configuration.home = {1.5, 0.3, -0.5, -1.2, 0.4, 2.4, -1.0};
    return configuration;
  }
  static void Step(Stepped<SimulatedArm>& arm, JointVector& before, Peak& peak) {
    arm.Cycle();
    const JointVector now = arm.Read<JointState>("Joints").velocity;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      peak.speed = std::max(peak.speed, std::abs(now[joint]));
      peak.acceleration =
          std::max(peak.acceleration, std::abs(now[joint] - before[joint]) / kArmPeriod);
    }
    before = now;
  }

  static constexpr double kArmPeriod = 1e-3;  // s
  static constexpr double kMoving = 0.05;     // rad/s

  Stepped<SimulatedArm>* led_ = &arm;
};

/// Expects that no peak is much higher than in a start from rest.
void ExpectNoLeap(const SteppedTrio::Peak& peak, const SteppedTrio::Peak& gentle) {
  constexpr double kMargin = 1.2;
  EXPECT_LE(peak.speed, kMargin * gentle.speed);
  EXPECT_LE(peak.acceleration, kMargin * gentle.acceleration);
}

constexpr double kLong = 6.0;  // s; the arm has joined the tour by then

/// Returns the peak of an arm that is connected at rest in this posture.
SteppedTrio::Peak GentleFrom(const JointVector& posture) {
  ArmConfiguration configuration;
  configuration.home = posture;
  SteppedTrio trio(configuration);
  trio.Lead("arm");
  return trio.PeakWithin(kLong);
}

TEST(Teleoperation, StartsFromThePositionOfAnotherArm) {
  SteppedTrio trio;
  trio.Lead("other");
  const auto gentle_there = trio.PeakWithin(kLong);
  trio.Lead("arm");
  const auto there = trio.PeakWithin(kLong);
  trio.Lead("other");
  const auto again = trio.PeakWithin(kLong);

  ExpectNoLeap(there, gentle_there);
  ExpectNoLeap(again, gentle_there);
}

TEST(Teleoperation, ResumesFromTheCurrentPositionOfTheArm) {
  SteppedTrio trio;
  trio.Lead("arm");
  (void)trio.PeakWithin(kLong);
  ASSERT_TRUE(trio.manager.Suspend("teleoperation"));
  auto& hand = trio.manager.Add<tendon_test::ArmClient>("hand");
  ASSERT_TRUE(trio.manager.Connect({"hand", "Robot"}, {"arm", "Control"}));
  ASSERT_TRUE(hand.move_to({{1.2, -0.1, 0.6, -1.1, 0.5, 2.2, 0.1}, 3.0}));
  trio.arm.Cycle(4000);

  ASSERT_TRUE(trio.manager.Start("teleoperation"));

  const auto gentle = GentleFrom(trio.position());
  ExpectNoLeap(trio.PeakWithin(kLong), gentle);
}

TEST(Teleoperation, RestartsGentlyWhenASuspendedArmResumes) {
  SteppedTrio trio;
  trio.Lead("arm");
  (void)trio.PeakWithin(kLong);
  ASSERT_TRUE(trio.manager.Suspend("arm"));
  for (int i = 0; i < 200; ++i) trio.teleoperation.Cycle();

  ASSERT_TRUE(trio.manager.Start("arm"));
  trio.arm.Cycle();  // the last row of this arm shows a motion

  const auto gentle = GentleFrom(trio.position());
  ExpectNoLeap(trio.PeakWithin(kLong), gentle);
}

TEST(Teleoperation, SetsTheArmInMotionWithinHalfASecond) {
  SteppedPair pair;
  pair.Connect();

  pair.Run(0.5);

  EXPECT_GT(pair.speed(), 0.02);
}

TEST(Teleoperation, DrivesTheArmWithoutAJump) {
  SteppedPair pair;
  pair.Connect();
  JointVector before = kReadyPosture;

  pair.Run(20.0, [&] {
    const JointVector after = pair.position();
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      EXPECT_LT(std::abs(after[joint] - before[joint]), 0.04) << joint;  // rad in 20 ms
    }
    EXPECT_LT(pair.worst(), 0.15);
    before = after;
  });

  EXPECT_EQ(pair.limits(), 0U);
}

TEST(Teleoperation, TheArmFollowsTheTourClosely) {
  SteppedPair pair;
  pair.Connect();
  pair.Run(4.0);
  JointVector least = pair.position();
  JointVector most = least;

  pair.Run(14.0, [&] {
    EXPECT_LT(pair.worst(), 0.05);
    const JointVector position = pair.position();
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      least[joint] = std::min(least[joint], position[joint]);
      most[joint] = std::max(most[joint], position[joint]);
    }
  });

  EXPECT_NEAR(most[0] - least[0], 2.2, 0.1);
  EXPECT_NEAR(most[3] - least[3], 1.1, 0.1);
  EXPECT_GT(most[1] - least[1], 0.8);
}

TEST(Teleoperation, ReversesWhenTheArmMeetsALimit) {
  ArmConfiguration narrow;
  narrow.upper[0] = 0.6;
  SteppedPair pair(narrow);
  pair.Connect();
  double after_limit = 0.0;

  pair.Run(30.0, [&] {
    if (pair.limits() > 0) after_limit = std::min(after_limit, pair.position()[0]);
  });

  EXPECT_GE(pair.limits(), 2U);  // at least once in each direction
  EXPECT_LE(pair.limits(), 6U);  // but not in every cycle
  EXPECT_LT(after_limit, -1.0);  // the arm went all the way back
  EXPECT_LE(pair.position()[0], 0.6);
}

TEST(Teleoperation, SeveralLimitsAtOnceCauseOneReversal) {
  ArmConfiguration narrow;
  narrow.upper[0] = 0.6;
  narrow.lower[6] = 0.4;
  narrow.upper[6] = 1.0;
  SteppedPair pair(narrow);
  pair.Connect();
  JointVector before = kReadyPosture;
  double moved = 0.0;

  pair.Run(60.0, [&] {
    const JointVector after = pair.position();
    moved += std::abs(after[3] - before[3]);
    before = after;
  });

  EXPECT_GE(pair.limits(), 4U);
  EXPECT_GT(moved, 2.0);  // the arm did not stay between the two limits
}

TEST(Teleoperation, WaitsForASlowArm) {
  ArmConfiguration slow;
  slow.velocity.fill(0.1);
  SteppedPair pair(slow);
  pair.Connect();

  pair.Run(20.0, [&] { EXPECT_LT(pair.worst(), 0.4); });
}

TEST(Teleoperation, ADisconnectedArmComesToRest) {
  SteppedPair pair;
  pair.Connect();
  pair.Run(5.0);
  ASSERT_GT(pair.speed(), 0.1);

  EXPECT_TRUE(pair.manager.Disconnect({"teleoperation", "Robot"}));
  pair.Run(1.0);
  const JointVector at_rest = pair.position();
  pair.Run(1.0);

  EXPECT_LT(pair.speed(), 1e-6);
  EXPECT_EQ(pair.position(), at_rest);
}

TEST(Teleoperation, ReconnectsFromThePositionOfTheArm) {
  SteppedPair pair;
  pair.Connect();
  pair.Run(7.0);
  EXPECT_TRUE(pair.manager.Disconnect({"teleoperation", "Robot"}));
  pair.Run(1.0);
  const JointVector at_rest = pair.position();

  pair.Connect();
  pair.Run(0.02);
  const JointVector target = pair.teleoperation.Read<Target>("Target").position;
  pair.Run(5.0);

  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    EXPECT_NEAR(target[joint], at_rest[joint], 1e-9) << joint;
  }
  EXPECT_GT(pair.speed(), 0.1);
}

TEST(Teleoperation, ACycleAllocatesNothing) {
  SteppedPair pair;
  pair.Connect();
  pair.Run(1.0);

  const AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    pair.arm.Cycle(kArmCycles);
    pair.teleoperation.Cycle();
  }
}

TEST(Teleoperation, RejectsAnInvalidConfiguration) {
  using tendon::ConfigurationError;
  EXPECT_THROW(Teleoperation("teleoperation", {.period = 0.1, .amplitude = 1.0}),
               ConfigurationError);
  EXPECT_THROW(Teleoperation("teleoperation", {.period = 12.0, .amplitude = std::nan("")}),
               ConfigurationError);
  EXPECT_EQ(tendon::test::Refusal([] {
              Teleoperation teleoperation("teleoperation", {.period = 12.0, .amplitude = 4.0});
            }),
            "configuration of 'teleoperation': amplitude is 4, expected 0 to 3");
}

TEST(TeleoperationThread, StoppingItStopsTheArm) {
  tendon::LocalManager manager;
  auto& arm = manager.Add<SimulatedArm>("arm");
  auto& teleoperation = manager.Add<Teleoperation>("teleoperation");
  ASSERT_TRUE(manager.StartAll());
  ASSERT_TRUE(manager.Connect({"teleoperation", "Robot"}, {"arm", "Control"}));
  const auto& joints =
      dynamic_cast<const tendon::Column<JointState>&>(*arm.tables().front()->Find("Joints"));
  const auto& tracking = dynamic_cast<const tendon::Column<Tracking>&>(
      *teleoperation.tables().front()->Find("Tracking"));
  const auto speed = [&joints] {
    JointState state;
    double fastest = 0.0;
    if (!joints.ReadNewest(state)) return 0.0;
    for (const double velocity : state.velocity) fastest = std::max(fastest, std::abs(velocity));
    return fastest;
  };

  EXPECT_TRUE(EventuallyTrue([&] { return speed() > 0.3; }));
  Tracking now;
  EXPECT_TRUE(tracking.ReadNewest(now));
  EXPECT_GT(now.worst, 0.0);
  EXPECT_TRUE(manager.Stop("teleoperation"));

  EXPECT_TRUE(EventuallyTrue([&] { return speed() < 1e-6; }));
}

}  // namespace
}  // namespace arm
