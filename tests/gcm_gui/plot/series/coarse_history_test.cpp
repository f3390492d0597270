#include <gcm_gui/plot/controls/memory_meter.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/coarse_history.h>
#include <gmock/gmock.h>

#include <QTest>
#include <bit>
#include <limits>

#include "../samples.h"

namespace tendon::gui {
namespace {

TEST(CoarseHistory, StoresTheExtremesOfEach100Milliseconds) {
  CoarseHistory history;
  history.append(Rows(50, 250));  // the value is the time in s

  ASSERT_EQ(history.buckets().size(), 3U);
  EXPECT_EQ(history.buckets()[1].from_ns, 100 * kMillisecond);
  EXPECT_DOUBLE_EQ(std::bit_cast<double>(history.buckets()[1].low), 0.100);
  EXPECT_DOUBLE_EQ(std::bit_cast<double>(history.buckets()[1].high), 0.199);
}

TEST(CoarseHistory, DropsTheOldestAndIgnoresNan) {
  CoarseHistory history;
  history.setLimit(2);
  history.append(Rows(0, 1000));
  history.append(Rows(1000, 1100, [](double) { return std::numeric_limits<double>::quiet_NaN(); }));

  ASSERT_EQ(history.buckets().size(), 2U);
  EXPECT_EQ(history.buckets().front().from_ns, 800 * kMillisecond);
}

TEST(CoarseHistory, RestartsWhenTheClockIsSetBack) {
  CoarseHistory history;
  history.append(Rows(100'000, 101'000));
  history.append(Rows(0, 100));

  EXPECT_EQ(history.buckets().size(), 1U);
}

TEST(ThinnedCurve, KeepsThePeaksOfDroppedSamples) {
  Curve curve({"p/a/state.x", "rad"}, 0);
  curve.setBudget(1 << 16);  // room for about 3.5 s at 1 kHz
  curve.append(Rows(0, 30'000, [](double t) { return t == 2.5 ? 9.0 : 0.0; }));
  EXPECT_TRUE(curve.isThinned());
  EXPECT_LE(curve.bytes(), std::size_t{1} << 16);

  const Envelope& envelope = curve.envelope({.from_ns = 0, .to_ns = 30 * kSecond, .count = 300});

  EXPECT_EQ(envelope.highest(), 9.0);
  EXPECT_EQ(envelope.high()[25], 9.0);
  EXPECT_EQ(envelope.high()[24], 0.0);
  for (std::size_t i = 0; i < 300; ++i) EXPECT_LE(envelope.low()[i], envelope.high()[i]) << i;
}

TEST(MemoryMeter, ShowsMemoryUseAndThinning) {
  PlotPanel panel(nullptr, 1'000'000);
  panel.addSignal("p/a/state.x", "rad");
  panel.append("p/a/state.x", Rows(0, 100'000));
  auto* meter = panel.findChild<MemoryMeter*>("memory");
  ASSERT_NE(meter, nullptr);

  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return meter->accessibleName().contains("of 1 MB for samples; of older samples, only the");
      },
      120'000));
}

}  // namespace
}  // namespace tendon::gui
