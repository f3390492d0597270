#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QTest>
#include <cmath>

#include "samples.h"

namespace tendon::gui {
namespace {

QString Joint(int i) { return QString("robot/arm/state.Joints.position[%1]").arg(i); }

// Saves pictures of typical plots for people. Each part of the plots has its own test.
class PlotPictures : public testing::TestWithParam<Appearance> {
 protected:
  void SetUp() override {
    const bool dark = GetParam() == Appearance::kDark;
    Theme::instance().choose(dark ? Theme::Choice::kDark : Theme::Choice::kLight);
    suffix_ = dark ? "-dark" : "-light";
    panel_.resize(830, 318);
    panel_.show();
  }

  void keep(const QString& name) {
    panel_.currentPlot().refresh();
    QTest::qWait(300);  // time to update the badge
    const QImage image = panel_.grab().toImage();
    EXPECT_EQ(image.size(), panel_.size());
    KeepPicture(image, name + suffix_);
  }

  void feed(const QString& path, const std::function<double(double)>& value) {
    panel_.append(path, Rows(0, 17'200, value));
    panel_.append(path, Rows(17'800, 30'000, value));
  }

  PlotPanel panel_;
  QString suffix_;
};

TEST_P(PlotPictures, RendersThreeJointsAndALoss) {
  for (int i = 0; i < 3; ++i) panel_.addSignal(Joint(i), "rad");
  feed(Joint(0), [](double t) { return std::sin(t * 0.7) * 1.1; });
  feed(Joint(1),
       [](double t) { return std::sin(t * 0.7 + 1.1) * 0.75 + 0.12 * std::sin(t * 3.1); });
  feed(Joint(2), [](double t) { return -0.6 + 0.5 * std::tanh(std::sin(t * 0.35) * 3); });
  keep("joints");
}

TEST_P(PlotPictures, RendersTwoUnitsNoiseAndAStaleSignal) {
  panel_.addSignal(Joint(0), "rad");
  panel_.addSignal("robot/arm/state.Joints.velocity[0]", "rad/s");
  panel_.addSignal("robot/force_sensor/state.Wrench.force[2]", "rad");
  panel_.addSignal("vision/camera/state.Latency", "ms");
  std::uint32_t random = 1;
  const auto noise = [&random](double) {
    random = random * 1664525U + 1013904223U;
    return static_cast<double>(random >> 8) / (1 << 24) * 0.4 - 0.9;
  };
  panel_.append(Joint(0), Rows(0, 30'000, [](double t) { return std::sin(t * 0.9); }));
  panel_.append("robot/arm/state.Joints.velocity[0]",
                Rows(0, 30'000, [](double t) { return 14 * std::cos(t * 0.9); }));
  panel_.append("robot/force_sensor/state.Wrench.force[2]", Rows(0, 30'000, noise));
  keep("units");
}

TEST_P(PlotPictures, RendersSingleSamples) {
  panel_.addSignal(Joint(0), "rad");
  panel_.append(Joint(0), Rows(0, 30'000, [](double t) { return std::sin(t * 60); }));
  panel_.currentPlot().refresh();
  for (int i = 0; i < 28; ++i) panel_.currentPlot().gestures().zoomTime(0.8, 400);
  panel_.currentPlot().setHover(300);
  keep("zoomed");
}

TEST_P(PlotPictures, RendersAnEmptyPlot) { keep("empty"); }

INSTANTIATE_TEST_SUITE_P(Themes, PlotPictures,
                         testing::Values(Appearance::kDark, Appearance::kLight),
                         [](const auto& instance) {
                           return instance.param == Appearance::kDark ? "Dark" : "Light";
                         });

}  // namespace
}  // namespace tendon::gui
