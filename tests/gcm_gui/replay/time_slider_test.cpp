#include <gcm_gui/replay/time_slider.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace tendon::gui {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;

class TimeSliderTest : public ::testing::Test {
 protected:
  TimeSliderTest() {
    slider_.resize(416, 32);  // 400 for the line
    slider_.setRange(100 * kSecondNs, 140 * kSecondNs);
    slider_.show();
  }
  [[nodiscard]] std::int64_t Sought() const { return sought_.last().at(0).toLongLong(); }

  TimeSlider slider_;
  QSignalSpy sought_{&slider_, &TimeSlider::sought};
  QSignalSpy steps_{&slider_, &TimeSlider::stepRequested};
};

TEST_F(TimeSliderTest, AClickGoesToTheMomentUnderTheMouse) {
  QTest::mouseClick(&slider_, Qt::LeftButton, {}, {8 + 100, 16});

  ASSERT_EQ(sought_.count(), 1);
  EXPECT_EQ(Sought(), 110 * kSecondNs);
  EXPECT_EQ(slider_.time(), 110 * kSecondNs);
}

TEST_F(TimeSliderTest, ADragFollowsTheMouseAndStaysInTheRecording) {
  QTest::mousePress(&slider_, Qt::LeftButton, {}, {8 + 100, 16});
  QTest::mouseMove(&slider_, {8 + 200, 16});
  QTest::mouseMove(&slider_, {900, 16});
  QTest::mouseRelease(&slider_, Qt::LeftButton, {}, {900, 16});

  EXPECT_EQ(Sought(), 140 * kSecondNs);
  EXPECT_FALSE(slider_.isSliderDown());
}

TEST_F(TimeSliderTest, KeysStepAndJump) {
  QTest::keyClick(&slider_, Qt::Key_Right);
  ASSERT_EQ(steps_.count(), 1);
  EXPECT_EQ(steps_.last().at(0).toInt(), 1);
  QTest::keyClick(&slider_, Qt::Key_End);
  EXPECT_EQ(Sought(), 140 * kSecondNs);
  QTest::keyClick(&slider_, Qt::Key_PageDown);
  EXPECT_EQ(Sought(), 136 * kSecondNs);
  QTest::keyClick(&slider_, Qt::Key_Home);
  EXPECT_EQ(Sought(), 100 * kSecondNs);
}

TEST_F(TimeSliderTest, TellsAScreenReaderThePartThatHasPassed) {
  slider_.setTime(110 * kSecondNs);

  EXPECT_EQ(slider_.value(), slider_.maximum() / 4);
}

TEST(MomentText, CountsFromTheBegin) {
  EXPECT_EQ(MomentText(0), "0:00.000");
  EXPECT_EQ(MomentText(62'345'000'000), "1:02.345");
  EXPECT_EQ(MomentText(3'725'120'000'000), "1:02:05.120");
}

}  // namespace
}  // namespace tendon::gui
