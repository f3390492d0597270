#include <gcm_gui/models/catalogue_filter.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>
#include <random>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

class CatalogueFilterTest : public ::testing::Test {
 protected:
  CatalogueFilterTest() {
    QObject::connect(&store_, &CatalogueStore::changed, &model_, &CatalogueModel::update);
    store_.replace(LookSystem(0).catalogue());
  }

  bool Shows(const QString& path) const { return filter_.indexOf(path).isValid(); }

  CatalogueStore store_;
  CatalogueModel model_;
  CatalogueFilter filter_{model_};
  QAbstractItemModelTester tester_{&filter_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(CatalogueFilterTest, MatchesPathsWithEveryWordInAnyOrder) {
  filter_.applyText("getjoints arm");

  EXPECT_TRUE(Shows("robot/arm/Drives.GetJoints"));
  EXPECT_TRUE(Shows("robot/arm"));  // the parent of the match
  EXPECT_FALSE(Shows("robot/arm/Drives.Stop"));
  EXPECT_FALSE(Shows("robot/force_sensor"));
}

TEST_F(CatalogueFilterTest, AMinusExcludesAWord) {
  filter_.applyText("arm -state");

  EXPECT_TRUE(Shows("robot/arm/Drives"));
  EXPECT_FALSE(Shows("robot/arm/state"));
}

TEST_F(CatalogueFilterTest, TypeMatchesARowOrItsParent) {
  filter_.applyText("type:required");
  EXPECT_TRUE(Shows("robot/controller/Arm.SetTorques"));
  EXPECT_FALSE(Shows("robot/arm"));

  filter_.applyText("type:read");
  EXPECT_TRUE(Shows("robot/arm/Drives.GetJoints"));
  EXPECT_FALSE(Shows("robot/arm/Drives.SetTorques"));
}

TEST_F(CatalogueFilterTest, StateMatchesTheNearestRowWithAState) {
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

TEST_F(CatalogueFilterTest, ProcAcceptsAGlobOrAPrefix) {
  filter_.applyText("proc:*sk");
  EXPECT_TRUE(Shows("desk/view"));
  EXPECT_FALSE(Shows("robot"));

  filter_.applyText("proc:rob");
  EXPECT_TRUE(Shows("robot/arm"));
  EXPECT_FALSE(Shows("desk"));
}

TEST_F(CatalogueFilterTest, HostMatchesTheHostOfTheProcess) {
  filter_.applyText("host:local");
  EXPECT_TRUE(Shows("robot/arm"));
  filter_.applyText("host:!local");
  EXPECT_FALSE(Shows("robot/arm"));
  filter_.applyText("host:*where");
  EXPECT_FALSE(Shows("robot/arm"));
}

TEST_F(CatalogueFilterTest, SlashesEncloseARegularExpression) {
  filter_.applyText("/ARM\\/.*get\\w+s$/");
  EXPECT_TRUE(Shows("robot/arm/Drives.GetJoints"));
  EXPECT_FALSE(Shows("robot/arm/Drives.Stop"));

  filter_.applyText("arm -/\\.get/");
  EXPECT_TRUE(Shows("robot/arm/Drives.Stop"));
  EXPECT_FALSE(Shows("robot/arm/Drives.GetJoints"));

  filter_.applyText("/(arm/");  // an incomplete regular expression
  EXPECT_FALSE(Shows("robot"));
}

TEST_F(CatalogueFilterTest, CountsMatchingRows) {
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
  EXPECT_TRUE(applied.wait(120'000));
  EXPECT_EQ(applied.count(), 1);
  EXPECT_FALSE(Shows("desk/view"));
}

TEST_F(CatalogueFilterTest, FollowsModelChanges) {
  filter_.applyText("state:not");
  SystemBuilder system = LookSystem(0);
  store_.replace(system.catalogue());
  (void)system.TakeChanges();

  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  store_.apply(system.TakeChanges());

  EXPECT_FALSE(Shows("desk/teleoperation"));
}

TEST_F(CatalogueFilterTest, AddsAndRemovesParentsWithTheirMatches) {
  SystemBuilder system = LookSystem(0);
  (void)system.TakeChanges();
  filter_.applyText("getwrench");
  const int before = filter_.matchCount();
  ComponentDescription sensor = *system.catalogue().FindComponent("robot", "force_sensor");
  sensor.name = "second";

  system.Process("lab").Component("lab", Task("other", 0, {})).Component("lab", sensor);
  store_.apply(system.TakeChanges());
  EXPECT_TRUE(Shows("lab/second/Wrench.GetWrench"));
  EXPECT_FALSE(Shows("lab/other"));
  EXPECT_EQ(filter_.matchCount(), before + 1);

  system.RemoveComponent("lab", "second");
  store_.apply(system.TakeChanges());
  EXPECT_FALSE(Shows("lab"));
  EXPECT_EQ(filter_.matchCount(), before);

  filter_.applyText({});
  EXPECT_TRUE(Shows("lab/other"));
}

TEST_F(CatalogueFilterTest, ForwardsValuesOfShownRows) {
  filter_.applyText("joints");
  QSignalSpy changed(&filter_, &QAbstractItemModel::dataChanged);
  const auto shape = std::make_shared<const std::vector<NumericField>>(
      NumericFields(Schema(Schema::Kind::kFloat64)));

  model_.showValues("robot/arm/state.Joints", {shape, ExactValues({0.5}), {}});
  EXPECT_GE(changed.count(), 1);
  const QModelIndex row = filter_.indexOf("robot/arm/state.Joints");
  EXPECT_EQ(row.siblingAtColumn(CatalogueModel::kValue).data().toString(), "0.5000");

  filter_.applyText("getwrench");
  changed.clear();
  model_.showValues("robot/arm/state.Joints", {shape, ExactValues({0.75}), {}});
  EXPECT_EQ(changed.count(), 0);
}

QStringList ShownPaths(const CatalogueFilter& filter, const QModelIndex& parent) {
  QStringList paths;
  for (int row = 0; row < filter.rowCount(parent); ++row) {
    const QModelIndex index = filter.index(row, 0, parent);
    paths.append(index.data(kPathRole).toString());
    paths += ShownPaths(filter, index);
  }
  return paths;
}

/// Returns the paths that match, by testing every item.
QStringList WantedPaths(const FilterExpression& expression, const CatalogueItem& item) {
  QStringList paths;
  for (const auto& child : item.children) paths += WantedPaths(expression, *child);
  if (!paths.isEmpty() || expression.Matches(item)) paths.prepend(item.path);
  return paths;
}

/// Applies random changes. QAbstractItemModelTester aborts on the first inconsistency.
TEST_F(CatalogueFilterTest, FollowsRandomChangesLikeANewFilter) {
  SystemBuilder system;
  std::mt19937 random(20261123);
  const auto pick = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const auto process = [&] { return "p" + std::to_string(pick(3)); };
  const auto component = [&] { return "c" + std::to_string(pick(4)); };
  const QStringList filters{"x1", "type:required state:!connected", "c1 -state", "state:lost", ""};
  store_.replace(system.catalogue());
  for (int step = 0; step < 500; ++step) {
    if (step % 50 == 0) filter_.applyText(filters[step / 50 % filters.size()]);
    switch (pick(6)) {
      case 0:
        system.Process(process(), pick(2) == 0 ? ProcessState::kLost : ProcessState::kAlive, step);
        break;
      case 1:
        pick(2) == 0 ? system.RemoveProcess(process())
                     : system.RemoveComponent(process(), component());
        break;
      case 2:
        system.Connect({process(), component(), "Arm"}, {process(), component(), "state"});
        break;
      default: {
        std::vector<ColumnDescription> columns;
        for (int i = pick(3); i >= 0; --i) columns.push_back(Column("x" + std::to_string(i), "t"));
        ComponentDescription task = Task(component(), 0, columns);
        if (pick(2) == 0) task.required.push_back({"Arm", {Read("Get", "t")}, {}, false});
        system.Component(process(), task);
      }
    }
    store_.apply(system.TakeChanges());

    const FilterExpression expression(filters[step / 50 % filters.size()]);
    QStringList wanted;
    for (int row = 0; row < model_.rowCount({}); ++row) {
      wanted += WantedPaths(expression, *model_.item(model_.index(row, 0, {})));
    }
    ASSERT_EQ(ShownPaths(filter_, {}), wanted) << "after step " << step;
  }
}

}  // namespace
}  // namespace tendon::gui
