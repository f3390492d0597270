#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gmock/gmock.h>
#include <qwt_scale_div.h>

#include <QFont>

namespace tendon::gui {
namespace {

QString TextOf(const AxisLabels& labels, double value) { return labels.label(value).text(); }

TEST(AxisLabels, HaveTheDigitsThatTheStepNeeds) {
  AxisLabels labels;
  labels.setStep(0.5);
  EXPECT_EQ(TextOf(labels, 1.5), "1.5");
  EXPECT_EQ(TextOf(labels, -1e-17), "0.0") << "no minus before nothing";
  labels.setStep(20);
  EXPECT_EQ(TextOf(labels, -40), "-40");
  labels.setStep(500'000);
  EXPECT_EQ(TextOf(labels, 2'500'000), "2.5e+06");
}

TEST(AxisLabels, UseTheTextsOfTheTicks) {
  AxisLabels labels;
  labels.setTicks({.places = {0, 1}, .texts = {"off", "on"}});

  EXPECT_EQ(TextOf(labels, 1), "on");
  EXPECT_EQ(TextOf(labels, 2), "2");
}

TEST(AxisLabels, NeverBecomeNarrower) {
  AxisLabels labels;
  labels.setAlignment(QwtScaleDraw::LeftScale);
  labels.setStep(0.001);
  labels.setScaleDiv(QwtScaleDiv(-20000, 1, {}, {}, {-12345.001}));
  const double wide = labels.extent(QFont());
  ASSERT_GT(wide, 30);

  labels.setStep(1);
  labels.setScaleDiv(QwtScaleDiv(0, 1, {}, {}, {1}));

  EXPECT_EQ(labels.extent(QFont()), wide);
}

TEST(TimeLabels, CountBackFromNow) {
  TimeLabels labels;
  labels.setStep(5);
  EXPECT_EQ(TextOf(labels, -25), "-25 s");
  EXPECT_EQ(TextOf(labels, 0), "now");
  labels.setStep(120);
  EXPECT_EQ(TextOf(labels, -240), "-4 min");
  labels.setStep(3600);
  EXPECT_EQ(TextOf(labels, -7200), "-2 h");
  labels.setStep(0.0002);
  EXPECT_EQ(TextOf(labels, -0.0014), "-1.4 ms");
}

TEST(TimeLabels, AHeldViewHasNoNow) {
  TimeLabels labels;

  EXPECT_TRUE(labels.setLive(false));

  EXPECT_EQ(TextOf(labels, 0), "0 s");
  EXPECT_FALSE(labels.setLive(false));
}

}  // namespace
}  // namespace tendon::gui
