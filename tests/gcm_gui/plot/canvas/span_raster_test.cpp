#include <gcm_gui/plot/canvas/span_raster.h>
#include <gmock/gmock.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "../samples.h"

namespace tendon::gui {
namespace {

constexpr int kWidth = 400;
constexpr int kHeight = 200;
constexpr TimeSlices kSlices{
    .from_ns = 0, .to_ns = kSecond, .count = kWidth * SpanRaster::kSlicesPerColumn};

// Draws a curve whose values are row numbers.
SpanRaster Drawn(const std::function<double(double seconds)>& row, int rate = 1000) {
  SampleRing ring;
  for (int i = 0; i <= rate; ++i) {
    const double seconds = static_cast<double>(i) / rate;
    const Sample sample{.time_ns = std::llround(seconds * 1e9),
                        .tick = static_cast<std::uint64_t>(i),
                        .value = row(seconds)};
    ring.append({&sample, 1});
  }
  Envelope envelope;
  envelope.build(ring, kSlices);
  SpanRaster raster;
  raster.begin({kWidth, kHeight});
  raster.draw(envelope, {}, 1, Qt::white);
  return raster;
}

TEST(SpanRaster, AFlatLineIsTwoPixelsThick) {
  const SpanRaster raster = Drawn([](double) { return 100.0; });

  const QImage image = raster.image();
  for (int x = 2; x < kWidth - 2; ++x) {
    EXPECT_EQ(qAlpha(image.pixel(x, 98)), 0);
    EXPECT_GE(qAlpha(image.pixel(x, 99)), 250);
    EXPECT_GE(qAlpha(image.pixel(x, 100)), 250);
    EXPECT_EQ(qAlpha(image.pixel(x, 101)), 0);
  }
}

TEST(SpanRaster, APeakOfOneSampleReachesItsHeight) {
  const SpanRaster raster =
      Drawn([](double t) { return std::abs(t - 0.5) < 1e-9 ? 20.0 : 150.0; }, 100'000);

  EXPECT_GT(qAlpha(raster.image().pixel(kWidth / 2, 21)), 60);
}

// Compares with the strokes of Qt, which are slower but known to be correct.
TEST(SpanRaster, MatchesAnAntialiasedStrokeOfQt) {
  const auto row = [](double t) {
    return 100 + 80 * std::sin(6 * std::numbers::pi * t) * std::exp(-t);
  };
  const SpanRaster raster = Drawn(row);
  const QImage ours = raster.image();  // shares the memory of the raster
  QImage theirs(kWidth, kHeight, QImage::Format_ARGB32_Premultiplied);
  theirs.fill(Qt::transparent);
  QPolygonF line;
  for (int i = 0; i <= 1000; ++i) line << QPointF(i * kWidth / 1000.0, row(i / 1000.0));
  QPainter painter(&theirs);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(Qt::white, 2));
  painter.drawPolyline(line);
  painter.end();

  KeepPicture(ours, "span_raster");
  int differing = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 2; x < kWidth - 2; ++x) {
      differing += std::abs(qAlpha(ours.pixel(x, y)) - qAlpha(theirs.pixel(x, y))) > 96 ? 1 : 0;
    }
  }
  EXPECT_LT(differing, 20);
}

TEST(SpanRaster, ClipsValuesFarOutside) {
  const SpanRaster raster = Drawn([](double t) { return t < 0.5 ? 1e300 : -1e300; });

  EXPECT_EQ(qAlpha(raster.image().pixel(10, 100)), 0);
  EXPECT_GT(qAlpha(raster.image().pixel(kWidth / 2, 100)), 100);
}

TEST(SpanRaster, BeginClearsTheOldPicture) {
  SpanRaster raster = Drawn([](double) { return 100.0; });

  raster.begin({kWidth, kHeight});

  EXPECT_EQ(qAlpha(raster.image().pixel(10, 100)), 0);
}

TEST(SpanRaster, DrawsLaterCurvesOnTop) {
  SpanRaster raster = Drawn([](double) { return 100.0; });
  SampleRing ring;
  ring.append(std::vector<Sample>{{.time_ns = 0, .tick = 0, .value = 100},
                                  {.time_ns = kSecond, .tick = 1, .value = 100}});
  Envelope envelope;
  envelope.build(ring, kSlices);

  raster.draw(envelope, {}, 1, Qt::red);

  EXPECT_EQ(QColor(raster.image().pixel(200, 100)), QColor(Qt::red));
}

TEST(SpanRaster, ADashedLineHasGapsInItsColumns) {
  SpanRaster raster = Drawn([](double) { return 300.0; });
  SampleRing ring;
  ring.append(std::vector<Sample>{{.time_ns = 0, .tick = 0, .value = 100},
                                  {.time_ns = kSecond, .tick = 1, .value = 100}});
  Envelope envelope;
  envelope.build(ring, kSlices);

  raster.draw(envelope, {}, 1, Qt::red, {.dash = 3, .gap = 2, .first = 4});

  const QImage image = raster.image();
  for (int x = 20; x < 25; ++x) {
    const bool is_gap = (x + 4) % 5 >= 3;
    EXPECT_EQ(qAlpha(image.pixel(x, 100)) == 0, is_gap) << x;
  }
}

TEST(Dashes, ThePatternGoesOnBeforeTheBeginOfTime) {
  const Dashes dashes{.dash = 3, .gap = 2, .first = -7};

  for (int x = 0; x < 10; ++x) EXPECT_EQ(dashes.isGap(x), (x + 3) % 5 >= 3) << x;
  EXPECT_FALSE(Dashes{}.isGap(4));
}

}  // namespace
}  // namespace tendon::gui
