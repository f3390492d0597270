// Tests every part of a plot with all kinds of numbers: limits, denormals, infinities, numbers that
// differ only in the last digits, and random numbers of RapidCheck.

#include <gcm_gui/plot/canvas/cursor_lines.h>
#include <gcm_gui/plot/canvas/span_raster.h>
#include <gcm_gui/plot/canvas/value_ticks.h>
#include <gcm_gui/plot/controls/legend_entries.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/csv_table.h>
#include <gcm_gui/plot/series/sample_statistics.h>
#include <gmock/gmock.h>
#include <qwt_plot_canvas.h>

#include <QBuffer>
#include <QPainter>
#include <QRegularExpression>
#include <QSvgGenerator>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

#include "samples.h"
#include "support/property.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

constexpr std::array kAllTime{
    VisibleSlices{.slices = {.from_ns = 0, .to_ns = kSecond, .count = 400}}};

/// Returns one row for each value, several rows per second.
std::vector<Sample> RowsOf(const std::vector<ExactNumber>& values) {
  std::vector<Sample> rows;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto time =
        static_cast<std::int64_t>(i) * kSecond / static_cast<std::int64_t>(values.size());
    rows.push_back({.time_ns = time, .tick = i, .value = values[i]});
  }
  return rows;
}

rc::Gen<std::vector<ExactNumber>> AnyReals() {
  const auto number =
      rc::gen::map(test::AnyDouble(), [](double value) { return ExactNumber(value); });
  return rc::gen::oneOf(
      rc::gen::container<std::vector<ExactNumber>>(number),
      // A constant, and two alternating numbers.
      rc::gen::map(number, [](ExactNumber one) { return std::vector<ExactNumber>(20, one); }),
      rc::gen::map(rc::gen::pair(number, number),
                   [](const auto& two) {
                     std::vector<ExactNumber> values;
                     for (int i = 0; i < 10; ++i)
                       values.insert(values.end(), {two.first, two.second});
                     return values;
                   }),
      // Numbers that differ only in their last digits.
      rc::gen::map(number, [](ExactNumber one) {
        std::vector<ExactNumber> values;
        for (int i = 0; i < 20; ++i) values.emplace_back(one.nearest() * (1 + i * 1e-13));
        return values;
      }));
}

template <typename Integer>
rc::Gen<std::vector<ExactNumber>> AnyIntegers() {
  const auto exact = [](Integer value) {
    return std::is_signed_v<Integer> ? ExactNumber::Signed(static_cast<std::int64_t>(value))
                                     : ExactNumber::Unsigned(static_cast<std::uint64_t>(value));
  };
  return rc::gen::oneOf(
      rc::gen::container<std::vector<ExactNumber>>(
          rc::gen::map(test::AnyInteger<Integer>(), exact)),
      // A counter, which may wrap around.
      rc::gen::map(test::AnyInteger<Integer>(), [exact](Integer first) {
        std::vector<ExactNumber> values;
        for (std::uint64_t i = 0; i < 50; ++i) {
          values.push_back(exact(static_cast<Integer>(static_cast<std::uint64_t>(first) + i)));
        }
        return values;
      }));
}

rc::Gen<std::vector<ExactNumber>> AnyNumbers() {
  return rc::gen::oneOf(AnyReals(), AnyIntegers<std::int64_t>(), AnyIntegers<std::uint64_t>());
}

rc::Gen<ValueScale> AnyScale() {
  return rc::gen::element(ValueScale::kLinear, ValueScale::kLogarithmic);
}

void CheckTicks(const ValueTicks& ticks) {
  RC_ASSERT(ticks.places.size() == ticks.texts.size());
  RC_ASSERT(ticks.places.size() <= 20U);
  for (const double place : ticks.places) RC_ASSERT(std::isfinite(place));
  const std::set<QString> texts(ticks.texts.begin(), ticks.texts.end());
  RC_ASSERT(texts.size() == ticks.texts.size());
  RC_ASSERT(!texts.contains("inf") && !texts.contains("nan"));
}

/// Checks that the range can be drawn and the labels differ.
void CheckAxis(const UnitAxis& axis, ValueScale scale) {
  RC_ASSERT(IsShowable(axis.range));
  const ValueTicks ticks = TicksOf(axis, scale, 7);
  CheckTicks(ticks);
  RC_ASSERT(!ticks.places.empty() || scale == ValueScale::kLogarithmic);
}

TEST(AnyNumber, FitsAnAxisWhoseLabelsDiffer) {
  test::CheckProperty([] {
    CurveSet set;
    set.setScale(*AnyScale());
    set.setFit(*rc::gen::element(Fit::kClose, Fit::kGrow, Fit::kSymmetric));
    Curve& curve = set.add({"p/a/state.x", ""});
    curve.append(RowsOf(*AnyNumbers()));
    set.fitAxes(kAllTime);
    CheckAxis(set.axes().front(), set.scale());

    // Adds other numbers, of the same kind or of another kind.
    std::vector<Sample> more = RowsOf(*AnyNumbers());
    for (Sample& sample : more) sample.tick += 1000;
    curve.append(more);
    set.fitAxes(kAllTime);
    CheckAxis(set.axes().front(), set.scale());
  });
}

TEST(AnyNumber, KeepsOtherCurvesOnItsAxisReadable) {
  test::CheckProperty([] {
    CurveSet set;
    set.add({"p/a/state.x", ""}).append(RowsOf({-1.0, 0.25, 1.0}));
    const double any = *test::AnyFinite();
    set.add({"p/a/state.y", ""}).append(RowsOf({any, any}));

    set.fitAxes(kAllTime);

    const UnitAxis& axis = set.axes().front();
    const double span = axis.range.span() / axis.frame.factor();
    if (std::abs(any) <= 1e6 || std::abs(any) > 1e12) RC_ASSERT(span <= 4e6);
    RC_ASSERT(set.beyondAxes().size() == (std::abs(any) > 1e12 ? 1 : 0));
  });
}

/// Returns the row of each sample in a picture of 50 rows, computed from the number alone. Samples
/// without a position are left out.
std::vector<std::pair<std::int64_t, double>> RowsOnScreen(const Curve& curve, const UnitAxis& axis,
                                                          ValueScale scale) {
  std::vector<std::pair<std::int64_t, double>> rows;
  const SampleRing& ring = curve.samples();
  for (std::uint64_t i = ring.firstIndex(); i < ring.endIndex(); ++i) {
    const Scaling& scaling = curve.scaling();
    const ExactNumber number =
        scaling.isNone() ? ring.number(i) : scaling.of(ring.number(i).nearest());
    // A line towards a value beyond all doubles ends before this value.
    if (!number.isFinite() && ring.number(i).isFinite()) return {};
    if (!number.isFinite()) continue;
    long double distance = number.nearest();
    if (number.kind() == ExactNumber::Kind::kSigned) {
      distance = static_cast<std::int64_t>(number.word());
    } else if (number.kind() == ExactNumber::Kind::kUnsigned) {
      distance = number.word();
    }
    distance -= axis.frame.base;
    const double place = scale == ValueScale::kLinear
                             ? static_cast<double>(distance * axis.frame.factor())
                             : PlaceOf(number.nearest(), scale);
    const double row = (axis.range.high - place) * (50 / axis.range.span());
    const bool is_below = std::isfinite(place) && scale == ValueScale::kLogarithmic && row > 49;
    if (is_below) continue;  // too near 0 for the picture
    rows.emplace_back(ring.time(i), std::isfinite(place) ? row : 49);
  }
  return rows;
}

/// Returns true if the line, which is two pixels thick, covers a pixel near this row.
bool IsSetNear(const QImage& image, int column, double row) {
  const int middle = static_cast<int>(std::floor(row));
  for (int y = std::max(0, middle - 2); y <= std::min(image.height() - 1, middle + 2); ++y) {
    if (qAlpha(image.pixel(column, y)) > 0) return true;
  }
  return false;
}

TEST(AnyNumber, IsDrawnWithinThePicture) {
  test::CheckProperty([] {
    CurveSet set;
    set.setScale(*AnyScale());
    Curve& curve = set.add({"p/a/state.x", ""});
    curve.append(RowsOf(*AnyNumbers()));
    if (*rc::gen::arbitrary<bool>()) {
      set.setLook(curve, {.scaling = {.factor = *rc::gen::element(-1.0, 1e12, 1e-12),
                                      .offset = *rc::gen::element(0.0, 1e15, -1e15)}});
    }
    set.fitAxes(kAllTime);
    const UnitAxis& axis = set.axes().front();
    const Envelope& envelope = curve.envelope(kAllTime[0].slices);
    for (std::size_t i = 0; i < envelope.low().size(); ++i) {
      if (envelope.low()[i] > envelope.high()[i]) continue;
      RC_ASSERT(std::isfinite(envelope.low()[i]) && std::isfinite(envelope.high()[i]));
    }

    SpanRaster raster;
    raster.begin({100, 50});
    raster.draw(envelope,
                {.low = axis.range.low,
                 .scale = -50 / axis.range.span(),
                 .offset = 50,
                 .factor = axis.frame.factor(),
                 .values = set.scale()},
                1, Qt::white);

    RC_ASSERT(raster.image().size() == QSize(100, 50));
    for (const auto& [time_ns, row] : RowsOnScreen(curve, axis, set.scale())) {
      const auto column = static_cast<int>(time_ns / (kSecond / 100));
      RC_LOG() << "column " << column << ", row " << row << "\n";
      RC_ASSERT(IsSetNear(raster.image(), column, row));
    }
  });
}

TEST(AnyNumber, AppearsInLegendCursorsAndStatistics) {
  test::CheckProperty([] {
    const std::vector<ExactNumber> values = *rc::gen::nonEmpty(AnyNumbers());
    CurveSet set;
    Curve& curve = set.add({"p/a/state.x", "V"});
    curve.append(RowsOf(values));
    set.fitAxes(kAllTime);

    const auto entries =
        LegendEntriesOf(set, std::nullopt, TimeSpan{.from_ns = 0, .to_ns = kSecond}, true);
    if (!curve.samples().empty()) RC_ASSERT(!entries.front().value.isEmpty());
    const auto statistics = StatisticsOf(curve.samples(), 0, kSecond);
    if (!statistics) return;
    RC_ASSERT(std::isfinite(statistics->mean.nearest()));
    RC_ASSERT(std::isfinite(statistics->deviation));
    RC_ASSERT(std::isfinite(statistics->rms));
    if (statistics->mean.isInteger()) RC_ASSERT(!statistics->mean.isBelow(statistics->lowest));

    Cursors cursors;
    cursors.set(Cursor::kA, 0);
    cursors.set(Cursor::kB, curve.samples().time(curve.samples().endIndex() - 1));
    const TimeWindow window;
    RC_ASSERT(CursorLines(set, window, cursors).lines().size() == 2U);
  });
}

TEST(AnyNumber, IntegersReadBackFromLegendAndCsv) {
  test::CheckProperty([] {
    const std::vector<ExactNumber> values = *rc::gen::nonEmpty(
        rc::gen::oneOf(AnyIntegers<std::int64_t>(), AnyIntegers<std::uint64_t>()));
    CurveSet set;
    Curve& curve = set.add({"p/a/state.x", ""});
    curve.append(RowsOf(values));
    set.fitAxes(kAllTime);

    const QString shown = LegendEntriesOf(set, std::nullopt, {}, false).front().value;
    RC_ASSERT(shown == values.back().text());

    QBuffer text;
    text.open(QIODevice::WriteOnly);
    RC_ASSERT(WriteCsv(CsvTableOf(set, 0, kSecond, 0), text).has_value());
    const QList<QByteArray> lines = text.data().trimmed().split('\n');
    RC_ASSERT(static_cast<std::size_t>(lines.size()) == values.size() + 1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const QByteArray cell = lines[static_cast<qsizetype>(i) + 1].split(',')[2];
      RC_ASSERT(QString::fromUtf8(cell) == values[i].text());
    }
  });
}

TEST(AnyNumber, RealsReadBackFromCsv) {
  test::CheckProperty([] {
    const double value = *test::AnyFinite();
    CurveSet set;
    set.add({"p/a/state.x", ""}).append(RowsOf({value}));
    QBuffer text;
    text.open(QIODevice::WriteOnly);
    RC_ASSERT(WriteCsv(CsvTableOf(set, 0, kSecond, 0), text).has_value());

    const QByteArray cell = text.data().trimmed().split('\n')[1].split(',')[2];

    double read = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), read);
    RC_ASSERT(error == std::errc());
    RC_ASSERT(end == cell.data() + cell.size());
    RC_ASSERT(std::bit_cast<std::uint64_t>(read) == std::bit_cast<std::uint64_t>(value));
  });
}

TEST(AnyNumber, TicksOfAnyZoomedRangeDiffer) {
  test::CheckProperty([] {
    const double low = *test::AnyFinite();
    const double high = *test::AnyFinite();
    const AxisRange range{.low = std::min(low, high), .high = std::max(low, high)};
    RC_PRE(IsShowable(range));

    CheckTicks(TicksOf(range, ValueScale::kLinear, 7));

    if (range.low >= -324 && range.high <= 309) {
      CheckTicks(TicksOf(range, ValueScale::kLogarithmic, 7));
    }
  });
}

TEST(AnyNumber, NeighboursAtIntegerLimitsHaveDifferentRows) {
  constexpr std::int64_t kMaxSigned = std::numeric_limits<std::int64_t>::max();
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  for (const auto& [low, high] :
       {std::pair(ExactNumber::Signed(kMaxSigned - 1), ExactNumber::Signed(kMaxSigned)),
        std::pair(ExactNumber::Unsigned(kLargest - 1), ExactNumber::Unsigned(kLargest)),
        std::pair(ExactNumber::Signed(-kMaxSigned - 1), ExactNumber::Signed(-kMaxSigned))}) {
    CurveSet set;
    Curve& curve = set.add({"p/a/state.x", ""});
    curve.append(RowsOf({low, high, low, high}));

    set.fitAxes(kAllTime);

    const Envelope& envelope = curve.envelope(kAllTime[0].slices);
    EXPECT_EQ(envelope.highest() - envelope.lowest(), 1) << qPrintable(low.text());
    const AxisRange& range = set.axes().front().range;
    EXPECT_TRUE(range.contains({envelope.lowest(), envelope.highest()}));
    EXPECT_LT(range.span(), 10);
  }
}

/// The whole view, with axes, dots, grid, legend and statistics.
class AnyNumberInAView : public testing::Test {
 protected:
  void SetUp() override { ShowView(view_); }

  void show(const std::vector<ExactNumber>& values, ValueScale scale) {
    view_.removeCurve("p/a/state.x");
    view_.setWindow(1s);
    view_.setScale(scale);
    view_.setStatistics(true);
    view_.addCurve({"p/a/state.x", "rad"}).append(RowsOf(values));
    view_.gestures().goLive();
    Painted(view_);
    view_.gestures().zoomValues(0.01, 10);
    view_.gestures().panValues(1e6);
    Painted(view_);
    for (int i = 0; i < 50; ++i) view_.gestures().zoomValues(1e3, 10);
    for (int i = 0; i < 50; ++i) view_.gestures().zoomValues(1e-3, 10);
    Painted(view_);
    view_.gestures().goBack();
    Painted(view_);
    for (const UnitAxis& axis : view_.curves().axes()) {
      ASSERT_TRUE(IsShowable(axis.range)) << axis.range.low << " to " << axis.range.high;
    }
  }

  PlotView view_;
};

TEST_F(AnyNumberInAView, DrawsAndZoomsExtremeValues) {
  for (const double edge : test::EdgeDoubles()) {
    for (const ValueScale scale : {ValueScale::kLinear, ValueScale::kLogarithmic}) {
      SCOPED_TRACE(edge);
      show(std::vector<ExactNumber>(20, edge), scale);
      show({edge, -edge, edge, -edge, edge}, scale);
      show({edge, 0.0, 1.0, edge, std::nan(""), edge}, scale);
    }
  }
}

TEST_F(AnyNumberInAView, AVectorPictureOfExtremeValuesHasFiniteLines) {
  for (const double edge : test::EdgeDoubles()) {
    SCOPED_TRACE(edge);
    show({edge, -edge, edge, 1.0}, ValueScale::kLinear);
    // Paints as for a file: the backing store would be an image.
    auto& canvas = static_cast<QwtPlotCanvas&>(*view_.canvas());
    canvas.setPaintAttribute(QwtPlotCanvas::BackingStore, false);
    QBuffer buffer;
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(view_.size());
    QPainter painter(&generator);
    view_.render(&painter);
    painter.end();

    const QRegularExpression lines("\\bd=\"([^\"]*)\"");
    auto each = lines.globalMatch(QString::fromUtf8(buffer.data()));
    EXPECT_TRUE(each.hasNext());
    while (each.hasNext()) {
      const QString line = each.next().captured(1);
      EXPECT_FALSE(line.contains('n')) << "inf or nan: " << line.left(200).toStdString();
    }
  }
}

}  // namespace
}  // namespace tendon::gui
