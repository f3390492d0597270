#include <gcm_gui/models/filter/catalogue_filter.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

class CatalogueFilterTest : public ::testing::Test {
 protected:
  CatalogueFilterTest() {
    QObject::connect(&store_, &CatalogueStore::changed, &model_, &CatalogueModel::update);
    store_.replace(LookSystem(0).catalog());
  }

  bool Shows(const QString& path) const { return filter_.indexOf(path).isValid(); }

  CatalogueStore store_;
  CatalogueModel model_;
  CatalogueFilter filter_{model_};
  QAbstractItemModelTester tester_{&filter_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(CatalogueFilterTest, EveryWordMustBeInThePathInAnyOrder) {
  filter_.applyText("getjoints arm");

  EXPECT_TRUE(Shows("robot/arm/Drives.GetJoints"));
  EXPECT_TRUE(Shows("robot/arm"));  // above it
  EXPECT_FALSE(Shows("robot/arm/Drives.Stop"));
  EXPECT_FALSE(Shows("robot/force_sensor"));
}

TEST_F(CatalogueFilterTest, AWordWithAMinusMustNotBe) {
  filter_.applyText("arm -state");

  EXPECT_TRUE(Shows("robot/arm/Drives"));
  EXPECT_FALSE(Shows("robot/arm/state"));
}

TEST_F(CatalogueFilterTest, TypeLooksAtWhatARowIsOrBelongsTo) {
  filter_.applyText("type:required");
  EXPECT_TRUE(Shows("robot/controller/Arm.SetTorques"));
  EXPECT_FALSE(Shows("robot/arm"));

  filter_.applyText("type:read");
  EXPECT_TRUE(Shows("robot/arm/Drives.GetJoints"));
  EXPECT_FALSE(Shows("robot/arm/Drives.SetTorques"));
}

TEST_F(CatalogueFilterTest, StateLooksAtTheNearestRowThatHasOne) {
  filter_.applyText("state:lost");
  EXPECT_TRUE(Shows("vision/camera/Video"));
  EXPECT_FALSE(Shows("robot"));

  filter_.applyText("state:not");
  EXPECT_TRUE(Shows("desk/teleoperation/Robot"));
  EXPECT_FALSE(Shows("robot/controller/Arm"));

  filter_.applyText("type:required state:!connected");
  EXPECT_TRUE(Shows("desk/teleoperation/Robot"));
  EXPECT_FALSE(Shows("robot/controller/Arm"));
}

TEST_F(CatalogueFilterTest, ProcTakesAGlobOrABeginning) {
  filter_.applyText("proc:*sk");
  EXPECT_TRUE(Shows("desk/view"));
  EXPECT_FALSE(Shows("robot"));

  filter_.applyText("proc:rob");
  EXPECT_TRUE(Shows("robot/arm"));
  EXPECT_FALSE(Shows("desk"));
}

TEST_F(CatalogueFilterTest, CountsTheRowsThatAreMeant) {
  EXPECT_EQ(filter_.matchCount(), model_.itemCount());

  filter_.applyText("type:process");

  EXPECT_EQ(filter_.matchCount(), 3);
}

TEST_F(CatalogueFilterTest, WaitsForAPauseInTyping) {
  QSignalSpy applied(&filter_, &CatalogueFilter::filterApplied);

  filter_.setText("a");
  filter_.setText("ar");
  filter_.setText("arm");

  EXPECT_EQ(applied.count(), 0);
  EXPECT_TRUE(applied.wait());
  EXPECT_EQ(applied.count(), 1);
  EXPECT_FALSE(Shows("desk/view"));
}

TEST_F(CatalogueFilterTest, FollowsTheModelWhileItFilters) {
  filter_.applyText("state:not");
  SystemBuilder system = LookSystem(0);
  store_.replace(system.catalog());
  (void)system.TakeChanges();

  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  store_.apply(system.TakeChanges());

  EXPECT_FALSE(Shows("desk/teleoperation"));
}

}  // namespace
}  // namespace tendon::gui
