#include <gcm_gui/plot/series/csv_table.h>
#include <gtest/gtest.h>

#include <QBuffer>
#include <memory>
#include <string>

#include "../samples.h"

namespace tendon::gui {
namespace {

constexpr std::int64_t kAll = 1000 * kSecond;

Sample At(std::int64_t ms, std::uint64_t tick, double value) {
  return {.time_ns = ms * kMillisecond, .tick = tick, .value = value};
}

Curve& Add(CurveSet& set, const QString& path, const QString& unit,
           const std::vector<Sample>& samples) {
  Curve& curve = set.add({path, unit});
  curve.append(samples);
  return curve;
}

std::string Csv(const CsvTable& table) {
  QBuffer text;
  text.open(QIODevice::WriteOnly);
  EXPECT_TRUE(WriteCsv(table, text).has_value());
  return text.data().toStdString();
}

TEST(CsvTable, HasALinePerTimeAndAColumnPerCurve) {
  CurveSet set;
  Add(set, "robot/arm/state.q[0]", "rad", {At(1, 1, 0.1), At(2, 2, -2.5)});
  Add(set, "robot/arm/state.q[1]", "rad", {At(2, 2, 1e-9)});

  const CsvTable table = CsvTableOf(set, 0, kAll, 1'700'000'000 * kSecond);

  EXPECT_EQ(Csv(table),
            "time_s,utc_estimated,robot/arm/state.q[0] [rad],robot/arm/state.q[1] [rad],"
            "robot/arm/state rows lost before\n"
            "0.001000000,2023-11-14T22:13:20.001000Z,0.1,,\n"
            "0.002000000,2023-11-14T22:13:20.002000Z,-2.5,1e-09,\n");
}

TEST(CsvTable, CountsLostRowsAtTheirPlace) {
  CurveSet set;
  Add(set, "p/a/state.x", "", {At(1, 1, 1), At(5, 5, 5)});
  Add(set, "p/a/state.y", "", {At(1, 1, 1), At(5, 5, 5)});

  QBuffer text;
  text.open(QIODevice::WriteOnly);
  const auto figures = WriteCsv(CsvTableOf(set, 0, kAll, 0), text);

  ASSERT_TRUE(figures.has_value());
  EXPECT_EQ(figures->rows, 2u);
  EXPECT_EQ(figures->lost, 3u) << "rows of one table, though two columns are shown";
  EXPECT_TRUE(text.data().endsWith("0.005000000,1970-01-01T00:00:00.005000Z,5,5,3\n"))
      << text.data().toStdString();
}

TEST(CsvTable, MarksARestart) {
  CurveSet set;
  Curve& curve = Add(set, "p/a/state.x", "", {At(1, 7, 1)});
  curve.beginEpoch();
  curve.append(std::vector<Sample>{At(2, 1, 2)});

  EXPECT_TRUE(QString::fromStdString(Csv(CsvTableOf(set, 0, kAll, 0))).endsWith(",2,restart\n"));
}

TEST(CsvTable, MergesTablesOfDifferentTasksByTime) {
  CurveSet set;
  Add(set, "p/a/state.x", "", {At(1, 1, 1), At(3, 2, 3)});
  Add(set, "p/b/state.y", "", {At(2, 1, 2)});

  const QStringList lines =
      QString::fromStdString(Csv(CsvTableOf(set, 0, kAll, 0))).split('\n', Qt::SkipEmptyParts);

  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[0].endsWith("p/a/state rows lost before,p/b/state rows lost before"));
  EXPECT_TRUE(lines[1].endsWith(",1,,,"));
  EXPECT_TRUE(lines[2].endsWith(",,2,,"));
  EXPECT_TRUE(lines[3].endsWith(",3,,,"));
}

TEST(CsvTable, ContainsOnlyVisibleCurvesAndTimes) {
  CurveSet set;
  Add(set, "p/a/state.x", "", Rows(0, 100));
  Add(set, "p/a/state.hidden", "", Rows(0, 100)).setVisible(false);

  const CsvTable table = CsvTableOf(set, 10 * kMillisecond, 20 * kMillisecond, 0);

  ASSERT_EQ(table.curves.size(), 1u);
  EXPECT_EQ(table.curves[0].times.size(), 11u);
  EXPECT_FALSE(table.empty());
  EXPECT_TRUE(CsvTableOf(set, kAll, kAll + 1, 0).empty());
}

TEST(CsvTable, WritesIntegersWithAllDigits) {
  CurveSet set;
  Sample stamp = At(1, 1, 0);
  stamp.value = ExactNumber::Signed(1'764'300'000'123'456'789);
  Sample most = At(1, 1, 0);
  most.value = ExactNumber::Unsigned(18'446'744'073'709'551'615U);
  Add(set, "p/a/state.stamp", "ns", {stamp});
  Add(set, "p/a/state.most", "", {most});

  EXPECT_TRUE(QString::fromStdString(Csv(CsvTableOf(set, 0, kAll, 0)))
                  .endsWith("Z,1764300000123456789,18446744073709551615,\n"));
}

TEST(CsvTable, WritesStatesByName) {
  CurveSet set;
  std::vector<Sample> modes{At(1, 1, 0), At(2, 2, 0), At(3, 3, 0)};
  modes[0].value = ExactNumber::Signed(0);
  modes[1].value = ExactNumber::Signed(7);
  modes[2].value = ExactNumber::Signed(9);
  Curve& curve = Add(set, "p/a/state.mode", "", modes);
  set.setNames(curve, std::make_shared<const ValueNames>(ValueNames{
                          .type = "arm.Mode", .all = {{0, "off"}, {7, "by hand, slow"}}}));

  const QStringList lines =
      QString::fromStdString(Csv(CsvTableOf(set, 0, kAll, 0))).split('\n', Qt::SkipEmptyParts);

  ASSERT_EQ(lines.size(), 4);
  EXPECT_TRUE(lines[1].endsWith("Z,off,"));
  EXPECT_TRUE(lines[2].endsWith("Z,\"by hand, slow\","));
  EXPECT_TRUE(lines[3].endsWith("Z,9,")) << "a value that has no name";
}

TEST(CsvTable, ACommaInAUnitIsQuoted) {
  CurveSet set;
  Add(set, "p/a/state.x", "N,m", {At(1, 1, 1)});

  EXPECT_TRUE(QString::fromStdString(Csv(CsvTableOf(set, 0, kAll, 0)))
                  .startsWith("time_s,utc_estimated,\"p/a/state.x [N,m]\","));
}

TEST(CsvTable, ReportsAWriteError) {
  CurveSet set;
  Add(set, "p/a/state.x", "", {At(1, 1, 1)});
  QBuffer closed;

  EXPECT_FALSE(WriteCsv(CsvTableOf(set, 0, kAll, 0), closed).has_value());
}

}  // namespace
}  // namespace tendon::gui
