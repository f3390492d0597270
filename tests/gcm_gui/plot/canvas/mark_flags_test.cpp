#include <gcm_gui/plot/canvas/mark_flags.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/mark_track.h>
#include <gcm_gui/theme/theme.h>
#include <gtest/gtest.h>
#include <qwt_scale_map.h>

#include <QTest>

#include "../samples.h"

namespace tendon::gui {
namespace {

Mark MarkAt(std::int64_t time_ns, const QString& label) {
  return {.time_ns = time_ns, .label = label, .text = "all of " + label};
}

class MarkFlagsTest : public testing::Test {
 protected:
  MarkFlagsTest() { panel_.resize(900, 320); }

  void Show() {
    panel_.addSignal("p/a/state.x", "rad");
    panel_.append("p/a/state.x", Rows(0, 30'000));
    panel_.show();
    (void)QTest::qWaitForWindowExposed(&panel_);
    view().refresh();
    // The window does not move from now on.
    view().setPaused(true);
  }
  PlotView& view() { return panel_.currentPlot(); }
  [[nodiscard]] double xOf(std::int64_t time_ns) {
    return view().transform(QwtAxis::XBottom, view().timeWindow().secondsAt(time_ns));
  }

  PlotPanel panel_;
};

TEST_F(MarkFlagsTest, DrawsAMarkAtItsTime) {
  Show();
  const QImage without = Painted(view());
  panel_.addMark({.kind = Mark::Kind::kCommand, .time_ns = 12 * kSecond, .label = "MoveTo"});
  const QImage with = Painted(view());

  const QPoint foot =
      view().canvas()->geometry().topLeft() +
      QPoint(static_cast<int>(std::round(xOf(12 * kSecond))), view().canvas()->height() - 4);
  EXPECT_EQ(with.pixelColor(foot), Theme::instance().color(Token::kAccent));
  EXPECT_NE(without.pixelColor(foot), with.pixelColor(foot));
}

TEST_F(MarkFlagsTest, CombinesOverlappingLabels) {
  MarkTrack track;
  TimeWindow window;
  QwtScaleMap map;
  map.setScaleInterval(window.from(), window.to());
  map.setPaintInterval(0, 900);
  for (int i = 0; i < 3; ++i) track.add(MarkAt(-20 * kSecond + i * kMillisecond, "Limit"));
  track.add({.time_ns = -20 * kSecond + 5 * kMillisecond, .label = "refused", .is_bad = true});
  track.add(MarkAt(-5 * kSecond, "Limit"));

  const auto flags = MarkFlags(track, window).flags(map, QRectF(0, 0, 900, 200));

  ASSERT_EQ(flags.size(), 2U);
  EXPECT_EQ(flags[0].label, "refused +3");
  EXPECT_EQ(flags[1].label, "Limit");
}

}  // namespace
}  // namespace tendon::gui
