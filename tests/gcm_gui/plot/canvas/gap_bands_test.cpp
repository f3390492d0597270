#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>
#include <qwt_scale_map.h>

#include <QApplication>

#include "../samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

class GapBandsTest : public testing::Test {
 protected:
  void SetUp() override {
    Theme::instance().choose(Theme::Choice::kDark);
    ShowView(view_);
    view_.setWindow(10s);
  }

  // Returns the colour at `ago` seconds, in a row without a curve.
  [[nodiscard]] QColor ColorAt(double ago) {
    const QImage image = Painted(view_);
    const QPoint on_canvas(static_cast<int>(view_.transform(QwtAxis::XBottom, -ago)),
                           view_.canvas()->height() - 6);
    return image.pixelColor(view_.canvas()->mapTo(&view_, on_canvas));
  }

  PlotView view_;
};

double Flat(double) { return 1.0; }

TEST_F(GapBandsTest, TintsLostRowsRed) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 5000, Flat));
  curve.append(Rows(7000, 10'000, Flat));

  const QColor tinted = ColorAt(4.2);
  const QColor plain = ColorAt(9.2);

  EXPECT_GT(tinted.red(), plain.red() + 10);
  EXPECT_EQ(plain, Theme::instance().color(Token::kPanel));
}

TEST_F(GapBandsTest, TintsARestartGrey) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(3000, 5000, Flat));
  std::vector<Sample> rows = Rows(0, 3000, Flat);
  for (Sample& row : rows) row.time_ns += 7 * kSecond;
  curve.beginEpoch();
  curve.append(rows);

  const QColor tinted = ColorAt(4.2);

  EXPECT_NE(tinted, Theme::instance().color(Token::kPanel));
  EXPECT_GE(tinted.blue(), tinted.red());
}

TEST_F(GapBandsTest, TintsSilenceUntilSamplesArrive) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 5000, Flat));
  view_.addCurve({"p/b/state.x", "rad"}).append(Rows(0, 10'000, Flat));
  EXPECT_EQ(ColorAt(1.2), Theme::instance().color(Token::kPanel));

  curve.setStale("waiting for p/a");
  view_.setWindow(10s);

  EXPECT_NE(ColorAt(1.2), Theme::instance().color(Token::kPanel));
}

TEST_F(GapBandsTest, TintsASuspensionDuringAndAfterIt) {
  Curve& curve = view_.addCurve({"p/a/state.x", "rad"});
  curve.append(Rows(0, 5000, Flat));
  Curve& other = view_.addCurve({"p/b/state.x", "rad"});
  other.append(Rows(0, 10'000, Flat));

  curve.setStandstill("suspended");
  view_.requestRedraw();
  const QColor silent = ColorAt(1.2);
  EXPECT_NE(silent, Theme::instance().color(Token::kPanel));
  EXPECT_GE(silent.blue(), silent.red());
  EXPECT_FALSE(curve.numberAt(8 * kSecond)) << "the last value is not what there is now";

  curve.setStandstill({});
  std::vector<Sample> rows = Rows(5000, 8000, Flat);  // no tick is missing
  for (Sample& row : rows) row.time_ns += 2 * kSecond;
  curve.append(rows);
  view_.requestRedraw();

  EXPECT_NE(ColorAt(4.2), Theme::instance().color(Token::kPanel));
  EXPECT_EQ(ColorAt(1.2), Theme::instance().color(Token::kPanel));
  EXPECT_FALSE(curve.numberAt(6 * kSecond));
}

}  // namespace
}  // namespace tendon::gui
