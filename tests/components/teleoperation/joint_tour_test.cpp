#include <components/simulated_arm/arm_configuration.h>
#include <components/teleoperation/joint_tour.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace arm {
namespace {

constexpr double kTourTime = 12.0;  // s

/// Returns the correlation of two joints over three rounds; 1 or -1 means the same shape.
double Correlation(std::size_t one, std::size_t other) {
  const JointTour tour(kTourTime, 1.0);
  constexpr int kSamples = 3600;
  std::array<double, 2> sum{};
  std::array<double, 3> squares{};
  for (int i = 0; i < kSamples; ++i) {
    const JointVector posture = tour.At(i * 3.0 * kTourTime / kSamples);
    const double a = posture[one];
    const double b = posture[other];
    sum[0] += a;
    sum[1] += b;
    squares[0] += a * a;
    squares[1] += b * b;
    squares[2] += a * b;
  }
  const auto n = static_cast<double>(kSamples);
  return (squares[2] - sum[0] * sum[1] / n) /
         std::sqrt((squares[0] - sum[0] * sum[0] / n) * (squares[1] - sum[1] * sum[1] / n));
}

TEST(JointTour, StaysWellWithinTheRangeOfAnArm) {
  const JointTour tour(kTourTime, 1.0);
  const ArmConfiguration arm;

  for (double time = -40.0; time < 40.0; time += 0.05) {
    const JointVector posture = tour.At(time);
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      EXPECT_GT(posture[joint], arm.lower[joint] + 0.3) << joint << " at " << time;
      EXPECT_LT(posture[joint], arm.upper[joint] - 0.3) << joint << " at " << time;
    }
  }
}

TEST(JointTour, IsSlowEnoughForAnArm) {
  const JointTour tour(kTourTime, 1.0);
  constexpr double kTimeStep = 0.01;  // s

  for (double time = 0.0; time < 3 * kTourTime; time += kTimeStep) {
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      EXPECT_LT(std::abs(tour.At(time + kTimeStep)[joint] - tour.At(time)[joint]) / kTimeStep, 1.0);
    }
  }
}

TEST(JointTour, EndsWhereItStarts) {
  const JointTour tour(kTourTime, 1.0);

  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    EXPECT_NEAR(tour.At(1.7)[joint], tour.At(1.7 + 3 * kTourTime)[joint], 1e-9) << joint;
  }
  for (const std::size_t joint : {0U, 1U, 3U, 5U}) {
    EXPECT_NEAR(tour.At(1.7)[joint], tour.At(1.7 + kTourTime)[joint], 1e-9) << joint;
  }
}

TEST(JointTour, TheJointsMoveDifferently) {
  EXPECT_LT(std::abs(Correlation(0, 1)), 0.9);
  EXPECT_LT(std::abs(Correlation(0, 3)), 0.9);
  EXPECT_LT(std::abs(Correlation(1, 3)), 0.9);
}

TEST(JointTour, AnAmplitudeOfZeroGivesOnePosture) {
  const JointTour tour(kTourTime, 0.0);

  EXPECT_EQ(tour.At(0.0), tour.At(4.2));
}

}  // namespace
}  // namespace arm
