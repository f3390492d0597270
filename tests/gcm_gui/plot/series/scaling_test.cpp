#include <gcm_gui/plot/controls/legend_entries.h>
#include <gcm_gui/plot/plot_layout.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/series/csv_table.h>
#include <gcm_gui/plot/series/sample_statistics.h>
#include <gcm_gui/plot/series/scaling.h>
#include <gmock/gmock.h>

#include <QBuffer>
#include <QLocale>
#include <cmath>
#include <limits>

#include "../samples.h"

namespace tendon::gui {
namespace {

using testing::HasSubstr;

const CurveKey kPosition{"robot/arm/state.Joints.position[0]", "rad"};
const CurveKey kOther{"robot/arm/state.Joints.position[1]", "rad"};
constexpr Scaling kScaling{.factor = -1000, .offset = 2};

TEST(Scaling, IsShownAfterTheUnit) {
  EXPECT_EQ(TextOf({.factor = 1000, .offset = 2}), "×1000 +2");
  EXPECT_EQ(TextOf({.factor = 1, .offset = -0.5}), "-0.5");
  EXPECT_EQ(TextOf({.factor = -1}), "×-1");
  EXPECT_EQ(TextOf({}), "");
  EXPECT_EQ(UnitOf("rad", {.factor = 1000, .offset = 2}), "rad ×1000 +2");
  EXPECT_EQ(UnitOf("", {.factor = 1000}), "×1000");
}

TEST(Scaling, RejectsUnusableValuesWithAReason) {
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  EXPECT_EQ(RefusalOf({}), std::nullopt);
  EXPECT_EQ(RefusalOf({.scaling = kScaling, .axis = "torque"}), std::nullopt);
  for (const auto& [look, reason] :
       {std::pair{CurveLook{.scaling = {.factor = 0}}, "flat line"},
        std::pair{CurveLook{.scaling = {.factor = kUnbounded}}, "between 1e-12 and 1e+12"},
        std::pair{CurveLook{.scaling = {.factor = std::nan("")}}, "between 1e-12 and 1e+12"},
        std::pair{CurveLook{.scaling = {.offset = -kUnbounded}}, "offset must lie between"},
        std::pair{CurveLook{.axis = QString(41, 'x')}, "at most 40"},
        std::pair{CurveLook{.axis = "two\nlines"}, "one line"}}) {
    ASSERT_TRUE(RefusalOf(look).has_value()) << reason;
    EXPECT_THAT(RefusalOf(look)->toStdString(), HasSubstr(reason));
  }
}

TEST(Scaling, ReadsNumbersAlikeInAllLocales) {
  for (const char* locale : {"C", "en_US", "de_DE", "fr_FR"}) {
    QLocale::setDefault(QLocale(locale));
    EXPECT_EQ(NumberIn(" 1e3 "), 1000);
    EXPECT_EQ(NumberIn("-0.5"), -0.5);
    for (const QString text : {"", "abc", "1 2", "nan", "inf", "1e999", "0,5", "1,000"}) {
      EXPECT_EQ(NumberIn(text), std::nullopt) << locale << qPrintable(text);
    }
  }
  QLocale::setDefault(QLocale::c());
}

/// A scaled curve; all displays of it must agree.
class ScaledCurveTest : public testing::Test {
 protected:
  ScaledCurveTest() {
    Curve& curve = curves_.add(kPosition);
    curve.append(Rows(0, 1001));
    curves_.setLook(curve, {.scaling = kScaling});
  }

  [[nodiscard]] const Curve& curve() const { return *curves_.find(kPosition.path); }

  const TimeSlices slices_{.from_ns = 0, .to_ns = 1001 * kMillisecond, .count = 100};
  CurveSet curves_;
};

TEST_F(ScaledCurveTest, IsDrawnScaled) {
  const Envelope& envelope = curve().envelope(slices_);

  EXPECT_DOUBLE_EQ(envelope.highest(), 2);
  EXPECT_DOUBLE_EQ(envelope.lowest(), -998);
  EXPECT_LT(envelope.low()[50], envelope.high()[50]);
  EXPECT_DOUBLE_EQ(curve().samples().value(1000), 1) << "the samples stay as they came";
}

TEST_F(ScaledCurveTest, AnEmptySliceStaysEmpty) {
  const Envelope& envelope =
      curve().envelope({.from_ns = -1000 * kMillisecond, .to_ns = 0, .count = 10});

  EXPECT_GT(envelope.low()[3], envelope.high()[3]);
}

TEST_F(ScaledCurveTest, HasItsOwnAxisByDefault) {
  Curve& other = curves_.add(kOther);
  other.append(Rows(0, 1001));
  ASSERT_EQ(curves_.axes().size(), 2U);
  EXPECT_EQ(curves_.axisOf(curve()).unit, "rad ×-1000 +2");
  EXPECT_EQ(curves_.axisOf(other).unit, "rad");

  curves_.setLook(*curves_.find(kPosition.path), {.scaling = kScaling, .axis = "rad"});
  ASSERT_EQ(curves_.axes().size(), 1U);
  const std::vector<VisibleSlices> seen{{.slices = slices_}};
  curves_.fitAxes(seen);
  EXPECT_LE(curves_.axisOf(other).range.low, -998);

  curves_.setLook(other, {.axis = "mine"});
  EXPECT_EQ(curves_.axisOf(other).unit, "mine");
}

TEST_F(ScaledCurveTest, ReadoutAndStatisticsAreScaled) {
  Curve scaled_before(kPosition, 0);
  scaled_before.append(Rows(0, 1001, [](double seconds) { return kScaling.of(seconds); }));
  const auto expected = StatisticsOf(scaled_before.samples(), 0, kSecond);
  const auto found = StatisticsOf(curve().samples(), 0, kSecond)->scaled(kScaling);

  EXPECT_DOUBLE_EQ(found.lowest.nearest(), expected->lowest.nearest());
  EXPECT_DOUBLE_EQ(found.highest.nearest(), expected->highest.nearest());
  EXPECT_NEAR(found.mean.nearest(), expected->mean.nearest(), 1e-9);
  EXPECT_NEAR(found.deviation, expected->deviation, 1e-9);
  EXPECT_NEAR(found.rms, expected->rms, 1e-9);
  EXPECT_EQ(curve().latestNumber(), -998.0);
  EXPECT_EQ(curve().numberAt(500 * kMillisecond), -498.0);
}

TEST_F(ScaledCurveTest, TheLegendShowsTheScaling) {
  const std::vector<VisibleSlices> seen{{.slices = slices_}};
  curves_.fitAxes(seen);

  const auto entries = LegendEntriesOf(curves_, {}, TimeSpan{.from_ns = 0, .to_ns = kSecond}, true);

  EXPECT_EQ(entries[0].unit, "rad ×-1000 +2");
  EXPECT_EQ(entries[0].value, "-998");
  EXPECT_THAT(entries[0].figures.toStdString(), HasSubstr("min    -998"));
}

TEST_F(ScaledCurveTest, CsvExportIsRawAndNotesTheScaling) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);

  ASSERT_TRUE(WriteCsv(CsvTableOf(curves_, 0, kMillisecond, 0), buffer));

  const QList<QByteArray> lines = buffer.data().split('\n');
  EXPECT_THAT(lines[0].toStdString(), HasSubstr("position[0] [rad] (raw; plotted ×-1000 +2)"));
  EXPECT_THAT(lines[2].toStdString(), HasSubstr(",0.001,"));
}

TEST(ScaledLayout, IsSavedAndRestored) {
  PlotPanel panel;
  panel.addSignal(kPosition.path, kPosition.unit);
  const CurveLook look{.scaling = kScaling, .axis = "mine"};
  panel.currentPlot().setLook(kPosition.path, look);

  PlotPanel other;
  ASSERT_EQ(ShowLayout(other, LayoutOf(panel)), std::nullopt);

  EXPECT_EQ(other.currentPlot().curve(kPosition.path)->look(), look);
  EXPECT_EQ(LayoutOf(other), LayoutOf(panel));
}

TEST(ScaledLayout, RejectsABadScalingWithAReason) {
  PlotPanel panel;
  panel.addSignal(kPosition.path, kPosition.unit);
  const QByteArray before = LayoutOf(panel);
  for (const auto& [wrong, reason] :
       {std::pair{R"("scale": 0)", "flat line"}, std::pair{R"("scale": "1")", "must be numbers"},
        std::pair{R"("offset": null)", "must be numbers"},
        std::pair{R"("offset": 1e300)", "offset must lie"}}) {
    const std::string layout =
        R"({"version": 1, "plots": [{"window": 1, "curves": [{"path": "p/a/state.x", )" +
        std::string(wrong) + "}]}]}";
    const auto told = ShowLayout(panel, QByteArray::fromStdString(layout));
    ASSERT_TRUE(told.has_value()) << wrong;
    EXPECT_THAT(told->toStdString(),
                testing::AllOf(HasSubstr("plot 1"), HasSubstr("p/a/state.x"), HasSubstr(reason)));
  }
  EXPECT_EQ(LayoutOf(panel), before);
}

TEST(ScaledLayout, ARemappedCurveKeepsTheScaling) {
  PlotPanel panel;
  panel.addSignal(kPosition.path, kPosition.unit);
  panel.currentPlot().setLook(kPosition.path, {.scaling = kScaling});

  panel.remap(kPosition.path, kOther);

  EXPECT_EQ(panel.currentPlot().curve(kOther.path)->scaling(), kScaling);
}

}  // namespace
}  // namespace tendon::gui
