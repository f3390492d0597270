#include <gcm_gui/plot/controls/rate_badge.h>
#include <gcm_gui/theme/theme.h>
#include <gmock/gmock.h>

#include <QImage>
#include <QPixmap>

namespace tendon::gui {
namespace {

TEST(RateBadge, ShowsZeroLosses) {
  EXPECT_EQ(BadgeText({{.source = "a", .rate = 999.97}}), "1000 Hz · 0 lost");
}

TEST(RateBadge, AddsUpTheLossesOfAllSources) {
  EXPECT_EQ(BadgeText({{.source = "a", .rate = 1000, .lost = 600},
                       {.source = "b", .rate = 20.004, .lost = 3, .repeated = 2}}),
            "20–1000 Hz · 603 lost · 2 repeated");
}

TEST(RateBadge, NamesThePlacesOfLosses) {
  EXPECT_EQ(PlacesText({}), "");
  EXPECT_EQ(PlacesText({.table = 600, .network = 3, .viewer = 0}),
            "; lost 600 in its process, 3 on the network");
  RateBadge badge;
  badge.setFigures({{.source = "a", .rate = 1000, .lost = 2, .losses = {.viewer = 2}}});
  EXPECT_TRUE(badge.toolTip().endsWith("; lost 2 in this window")) << badge.toolTip().toStdString();
}

TEST(RateBadge, NamesNoPlaceWithoutLosses) {
  RateBadge badge;
  badge.setFigures({{.source = "a", .rate = 1000, .losses = {.table = 600}}});
  EXPECT_TRUE(badge.toolTip().endsWith("0 rows lost, 0 repeated")) << badge.toolTip().toStdString();
}

TEST(RateBadge, CountsSilentSources) {
  EXPECT_EQ(BadgeText({{.source = "a", .rate = 1000}, {.source = "b"}}),
            "1000 Hz · 0 lost · 1 silent");
  EXPECT_EQ(BadgeText({{.source = "a"}}), "0 Hz · 0 lost");
}

TEST(RateBadge, SlowRatesHaveADecimalDigit) {
  EXPECT_EQ(RateText(0.5), "0.5 Hz");
  EXPECT_EQ(RateText(19.83), "19.8 Hz");
  EXPECT_EQ(RateText(0), "0 Hz");
}

TEST(RateBadge, TurnsRedWithTheFirstLoss) {
  RateBadge badge;
  badge.setFigures({{.source = "a", .rate = 1000}});
  EXPECT_FALSE(badge.property("role").toString().contains("bad"));

  badge.setFigures({{.source = "a", .rate = 1000, .lost = 1}});

  EXPECT_TRUE(badge.property("role").toString().contains("bad"));
  EXPECT_EQ(badge.accessibleName(), "Rate and lost rows: 1000 Hz · 1 lost");
}

TEST(RateBadge, IsShortenedIfThereIsLittleRoom) {
  RateBadge badge;
  badge.setFigures({{.source = "a", .rate = 1000, .lost = 600}, {.source = "b"}});

  EXPECT_LT(badge.minimumSizeHint().width(), badge.sizeHint().width());
  EXPECT_TRUE(badge.sizePolicy().horizontalPolicy() & QSizePolicy::ShrinkFlag);
}

TEST(RateBadge, IsShownWholeIfThereIsRoom) {
  for (const double rate : {0.0, 1.0, 17.0, 1000.0, 1234.0}) {
    RateBadge badge;
    badge.setFigures({{.source = "a", .rate = rate}});
    QToolButton plain;  // with the whole text
    plain.setObjectName(badge.objectName());
    SetRole(plain, "mono dim");
    plain.setText(badge.text());
    badge.resize(badge.sizeHint());
    plain.resize(badge.size());

    EXPECT_EQ(badge.grab().toImage(), plain.grab().toImage()) << badge.text().toStdString();
  }
}

TEST(RateBadge, TheToolTipListsEachSource) {
  RateBadge badge;

  badge.setFigures(
      {{.source = "p/a/state", .rate = 1000, .lost = 1}, {.source = "p/b/state", .rate = 20}});

  EXPECT_THAT(badge.toolTip().toStdString(), testing::HasSubstr("p/a/state: 1000 Hz, 1 row lost"));
  EXPECT_THAT(badge.toolTip().toStdString(), testing::HasSubstr("p/b/state: 20 Hz, 0 rows lost"));
}

}  // namespace
}  // namespace tendon::gui
