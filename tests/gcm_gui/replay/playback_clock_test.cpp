#include <gcm_gui/replay/playback_clock.h>
#include <gtest/gtest.h>

namespace tendon::gui {
namespace {

using Turn = PlaybackClock::Turn;

constexpr std::int64_t kFirst = 1'000'000;
constexpr std::int64_t kLast = 2'000'000;

TEST(PlaybackClock, StandsAtTheBeginUntilItIsPlayed) {
  PlaybackClock clock(kFirst, kLast);

  EXPECT_EQ(clock.position(500), kFirst);
  clock.play(1000);
  EXPECT_EQ(clock.position(1400), kFirst + 400);
}

TEST(PlaybackClock, KeepsItsPositionWhilePausedAndWhenTheSpeedChanges) {
  PlaybackClock clock(kFirst, kLast);
  clock.play(0);

  clock.pause(100);
  EXPECT_EQ(clock.position(900), kFirst + 100);
  clock.play(1000);
  clock.setSpeed(4.0, 1100);
  EXPECT_EQ(clock.position(1100), kFirst + 200);
  EXPECT_EQ(clock.position(1200), kFirst + 600);
}

TEST(PlaybackClock, LimitsTheSpeed) {
  PlaybackClock clock(kFirst, kLast);

  clock.setSpeed(100.0, 0);
  EXPECT_EQ(clock.speed(), PlaybackClock::kFastest);
  clock.setSpeed(0.0, 0);
  EXPECT_EQ(clock.speed(), PlaybackClock::kSlowest);
}

TEST(PlaybackClock, GoesOnFromWhereItJumpsToAndStaysInTheRecording) {
  PlaybackClock clock(kFirst, kLast);
  clock.play(0);

  clock.seek(kFirst + 500'000, 10);
  EXPECT_EQ(clock.position(20), kFirst + 500'010);
  clock.seek(0, 30);
  EXPECT_EQ(clock.position(30), kFirst);
  clock.seek(kLast + 5, 40);
  EXPECT_EQ(clock.position(50), kLast);
}

TEST(PlaybackClock, EndsAtTheEndAndPlaysFromTheBeginNextTime) {
  PlaybackClock clock(kFirst, kLast);
  clock.play(0);

  EXPECT_EQ(clock.update(999'999), Turn::kNone);
  EXPECT_EQ(clock.update(1'000'000), Turn::kEnded);
  EXPECT_FALSE(clock.isPlaying());
  EXPECT_EQ(clock.position(3'000'000), kLast);
  EXPECT_EQ(clock.update(3'000'000), Turn::kNone);
  clock.play(4'000'000);
  EXPECT_EQ(clock.position(4'000'100), kFirst + 100);
}

TEST(PlaybackClock, BeginsAgainAtTheEndWhenItLoops) {
  PlaybackClock clock(kFirst, kLast);
  clock.setLooping(true);
  clock.play(0);

  EXPECT_EQ(clock.update(1'000'001), Turn::kBeganAgain);
  EXPECT_TRUE(clock.isPlaying());
  EXPECT_EQ(clock.position(1'000'101), kFirst + 100);
}

TEST(PlaybackClock, AVeryLongTimeDoesNotOverflow) {
  PlaybackClock clock(kFirst, kLast);
  clock.setSpeed(16.0, 0);
  clock.play(0);

  EXPECT_EQ(clock.position(INT64_MAX), kLast);
}

TEST(PlaybackClock, StepsThroughTheSpeeds) {
  PlaybackClock clock(0, 10);

  for (int step = 0; step < 8; ++step) clock.setSpeed(clock.slowerSpeed(), 0);
  EXPECT_EQ(clock.speed(), PlaybackClock::kSlowest);
  for (const double speed : PlaybackClock::kSpeeds) {
    EXPECT_EQ(clock.speed(), speed);
    clock.setSpeed(clock.fasterSpeed(), 0);
  }
  EXPECT_EQ(clock.speed(), PlaybackClock::kFastest);
}

}  // namespace
}  // namespace tendon::gui
