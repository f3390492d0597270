#include <gcm_console/output/curve_picture.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/property.h"

namespace console {
namespace {

using tendon::NumericValue;
using tendon::Schema;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kShown = 10.0;  // s

const Schema kReal(Schema::Kind::kFloat64);

/// Returns a curve with one value per second.
template <typename T>
NumberCurve CurveOf(const Schema& schema, const std::vector<T>& values) {
  NumberCurve curve{.title = "a/b/state.X", .unit = "", .schema = schema, .samples = {}};
  for (const T& value : values) {
    curve.samples.push_back({static_cast<double>(curve.samples.size()), NumericValue(value)});
  }
  return curve;
}
std::string PictureOfOne(const NumberCurve& curve, int rows = 20) {
  return PictureOf(std::vector<NumberCurve>{curve}, kShown, 80, rows);
}
/// Returns the labels from top to bottom.
std::vector<std::string> LabelsIn(const std::string& picture) {
  std::istringstream lines(picture);
  std::vector<std::string> labels;
  std::string line;
  std::getline(lines, line);  // the title
  while (std::getline(lines, line) && line.find("now") == line.npos) {
    const std::size_t begin = line.find_first_not_of(' ');
    const std::string label = line.substr(begin, line.find(' ', begin) - begin);
    const bool is_curve = label.starts_with("\xe2");
    if (!is_curve) labels.push_back(label);
  }
  return labels;
}
/// Returns the rows of dots, with one entry per character.
std::vector<std::vector<unsigned>> CellsIn(const std::string& picture) {
  std::istringstream lines(picture);
  std::vector<std::vector<unsigned>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::vector<unsigned> cells;
    for (std::size_t at = line.find('\xe2'); at < line.size(); at += 3) {
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(line[at + i]); };
      cells.push_back(((byte(1) & 0x3U) << 6U) | (byte(2) & 0x3fU));
    }
    if (!cells.empty()) rows.push_back(cells);
  }
  return rows;
}

TEST(CurvePicture, LabelsOfACounterAreAllDifferent) {
  const auto labels = LabelsIn(PictureOfOne(CurveOf(
      Schema(Schema::Kind::kUint64), std::vector<std::uint64_t>{9'000'000'000, 9'000'000'004})));

  EXPECT_THAT(labels,
              ElementsAre("9000000004", "9000000003", "9000000002", "9000000001", "9000000000"));
}

TEST(CurvePicture, PrintsTheNewestValueExactly) {
  constexpr std::uint64_t kOdd = (std::uint64_t{1} << 53U) + 1;
  EXPECT_THAT(PictureOfOne(CurveOf(Schema(Schema::Kind::kUint64), std::vector{kOdd - 1, kOdd})),
              HasSubstr("a/b/state.X = 9007199254740993\n"));
  EXPECT_THAT(PictureOfOne(CurveOf(kReal, std::vector{0.1 + 0.2})),
              HasSubstr("a/b/state.X = 0.30000000000000004\n"));
  EXPECT_THAT(PictureOfOne(CurveOf(kReal, std::vector{std::numeric_limits<double>::infinity()})),
              HasSubstr("a/b/state.X = inf\n"));
}

TEST(CurvePicture, LabelsStatesByName) {
  const Schema mode = Schema::Enum("test.Mode", {{"fault", -3}, {"idle", 0}, {"moving", 7}});
  const std::string picture = PictureOfOne(CurveOf(mode, std::vector<std::int32_t>{0, 7, -3, 0}));

  EXPECT_THAT(picture, HasSubstr("a/b/state.X = idle\n"));
  EXPECT_THAT(LabelsIn(picture), ElementsAre("moving", "idle", "fault"));
  EXPECT_THAT(LabelsIn(PictureOfOne(CurveOf(Schema(Schema::Kind::kBool), std::vector{true}))),
              ElementsAre("true", "false"));
}

/// Between two samples of a state, only two rows have dots, except where the state changes.
TEST(CurvePicture, StatesAreSteps) {
  const auto cells =
      CellsIn(PictureOfOne(CurveOf(Schema(Schema::Kind::kBool), std::vector{false, true, false})));

  ASSERT_EQ(cells.size(), 18U);
  std::set<std::size_t> columns_between;  // columns with a dot between the two states
  for (std::size_t row = 1; row + 1 < cells.size(); ++row) {
    for (std::size_t column = 0; column < cells[row].size(); ++column) {
      if (cells[row][column] != 0) columns_between.insert(column);
    }
  }
  EXPECT_EQ(columns_between.size(), 2U) << "one for each change";
}

TEST(CurvePicture, FloatsAreLines) {
  const auto cells = CellsIn(PictureOfOne(CurveOf(kReal, std::vector{0.0, 1.0})));

  ASSERT_EQ(cells.size(), 18U);
  for (const auto& row : cells) {
    EXPECT_TRUE(std::ranges::any_of(row, [](unsigned cell) { return cell != 0; }));
  }
}

TEST(CurvePicture, DrawsNanAsAGap) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto dots = [](const std::vector<double>& values) {
    std::size_t count = 0;
    for (const auto& row : CellsIn(PictureOfOne(CurveOf(kReal, values)))) {
      count += static_cast<std::size_t>(
          std::ranges::count_if(row, [](unsigned cell) { return cell != 0; }));
    }
    return count;
  };

  EXPECT_LT(dots({1, none, 1}), dots({1, 1, 1}) / 4);
}

TEST(CurvePicture, DoesNotScaleToNoiseAtRest) {
  EXPECT_THAT(LabelsIn(PictureOfOne(CurveOf(kReal, std::vector{5e-14, -2e-14, 3e-14}))),
              ElementsAre("1.0", "0.5", "0.0", "-0.5", "-1.0"));
}

/// Returns the number of characters before the dots. It is the same in each row.
std::size_t MarginIn(const std::string& picture) {
  std::istringstream lines(picture);
  std::set<std::size_t> margins;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t margin = line.find('\xe2');
    if (margin != line.npos) margins.insert(margin);
  }
  RC_ASSERT(margins.size() == 1U);
  return *margins.begin();
}

/// Checks properties of every picture: its height and width, and that no label occurs twice.
void CheckPicture(const NumberCurve& curve, int columns, int rows) {
  constexpr std::size_t kFewestDots = 8;  // minimum width of the curve, in characters
  const std::string picture = PictureOf(std::vector<NumberCurve>{curve}, kShown, columns, rows);
  const auto cells = CellsIn(picture);
  const auto curve_rows = static_cast<std::size_t>(std::max(rows - 2, kFewestCurveRows));
  RC_ASSERT(cells.size() == curve_rows);
  const auto lines = static_cast<std::size_t>(std::ranges::count(picture, '\n'));
  RC_ASSERT(lines == curve_rows + 2);  // and the lines for the title and the time
  const std::size_t margin = MarginIn(picture);
  const auto width = std::max(static_cast<std::size_t>(columns), margin + kFewestDots);
  for (const auto& row : cells) RC_ASSERT(margin + row.size() == width);
  const auto labels = LabelsIn(picture);
  RC_ASSERT(std::set(labels.begin(), labels.end()).size() == labels.size());
}

template <typename T>
void CheckPicturesOf(const Schema& schema, const rc::Gen<T>& any) {
  tendon::test::CheckProperty([&] {
    const auto values = *rc::gen::nonEmpty(rc::gen::container<std::vector<T>>(any));
    CheckPicture(CurveOf(schema, values), *rc::gen::inRange(1, 200), *rc::gen::inRange(1, 60));
  });
}

TEST(CurvePictureProperty, HoldsForAnyDoubles) {
  CheckPicturesOf<double>(kReal, tendon::test::AnyDouble());
}

TEST(CurvePictureProperty, HoldsForAnyIntegers) {
  CheckPicturesOf<std::int64_t>(Schema(Schema::Kind::kInt64),
                                tendon::test::AnyInteger<std::int64_t>());
  CheckPicturesOf<std::uint64_t>(Schema(Schema::Kind::kUint64),
                                 tendon::test::AnyInteger<std::uint64_t>());
}

TEST(CurvePictureProperty, HoldsForAnyStates) {
  const Schema mode = Schema::Enum("test.Mode", {{"off", std::numeric_limits<std::int32_t>::min()},
                                                 {"on", std::numeric_limits<std::int32_t>::max()}});
  CheckPicturesOf<std::int32_t>(mode, tendon::test::AnyInteger<std::int32_t>());
}

}  // namespace
}  // namespace console
