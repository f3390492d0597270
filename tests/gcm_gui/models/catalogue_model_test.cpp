#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QPersistentModelIndex>
#include <QSignalSpy>
#include <algorithm>
#include <random>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

class CatalogueModelTest : public ::testing::Test {
 protected:
  CatalogueModelTest() {
    QObject::connect(&store_, &CatalogueStore::changed, &model_, &CatalogueModel::update);
  }

  void Show(SystemBuilder& system) { store_.apply(system.TakeChanges()); }

  QString Text(const QString& path, int column = CatalogueModel::kName) const {
    return model_.indexOf(path).siblingAtColumn(column).data().toString();
  }
  QString Value(const QString& path) const { return Text(path, CatalogueModel::kValue); }

  CatalogueStore store_;
  CatalogueModel model_;
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(CatalogueModelTest, ShowsProcessesComponentsInterfacesAndMembers) {
  SystemBuilder system = LookSystem(0);
  Show(system);

  EXPECT_EQ(Text("robot"), "robot");
  EXPECT_EQ(Value("robot"), "localhost");
  EXPECT_EQ(Value("robot/arm"), "1 kHz");
  EXPECT_EQ(Value("robot/arm/Drives"), "1 client");
  EXPECT_EQ(Value("robot/arm/Drives.SetTorques"), "write");
  EXPECT_EQ(Value("robot/arm/Drives.LimitExceeded"), "event");
  EXPECT_EQ(Value("desk/teleoperation/Robot"), "not connected");
  EXPECT_EQ(Value("robot/controller/Arm"), "← arm/Drives");
}

TEST_F(CatalogueModelTest, AWaitingComponentNamesItsMissingInterface) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  const auto tip = [this] {
    return model_.indexOf("desk/teleoperation").data(Qt::ToolTipRole).toString();
  };
  const auto mark = [this] {
    const QModelIndex name = model_.indexOf("desk/teleoperation");
    return name.siblingAtColumn(CatalogueModel::kValue).data(kMarkRole).value<StateMark>();
  };
  EXPECT_EQ(Value("desk/teleoperation"), "waiting for Robot");
  EXPECT_TRUE(tip().endsWith("\nwaiting for Robot: not connected")) << tip().toStdString();
  EXPECT_EQ(mark(), StateMark::kWarning);

  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  Show(system);

  EXPECT_EQ(Value("desk/teleoperation"), "50 Hz");
  EXPECT_FALSE(tip().contains("waiting"));
  EXPECT_EQ(mark(), StateMark::kActive);
}

TEST_F(CatalogueModelTest, AStateTableShowsColumnsInsteadOfReadCommands) {
  SystemBuilder system = LookSystem(0);
  Show(system);

  const QModelIndex state = model_.indexOf("robot/arm/state");
  ASSERT_EQ(model_.rowCount(state), 3);
  EXPECT_EQ(model_.item(model_.index(0, 0, state))->kind, ItemKind::kColumn);
}

TEST_F(CatalogueModelTest, ListsCycleColumnsLast) {
  SystemBuilder system = LookSystem(0);
  ComponentDescription arm = *system.catalogue().FindComponent("robot", "arm");
  auto& columns = arm.tables.front().columns;
  std::rotate(columns.begin(), columns.begin() + 1, columns.end());
  ASSERT_EQ(columns.front().name, "Cycle");
  system.Component("robot", arm);

  Show(system);

  const QModelIndex state = model_.indexOf("robot/arm/state");
  EXPECT_EQ(model_.index(0, 0, state).data().toString(), "Joints");
  EXPECT_EQ(model_.index(2, 0, state).data().toString(), "CycleSummary");
}

TEST_F(CatalogueModelTest, StrikesOutALostProcessAndShowsForHowLong) {
  SystemBuilder system = LookSystem(100 * kSecond);
  Show(system);
  model_.setNow(112 * kSecond);

  EXPECT_EQ(Value("vision"), "lost 12 s");
  EXPECT_TRUE(model_.indexOf("vision").data(kStruckRole).toBool());
  EXPECT_TRUE(model_.indexOf("vision/camera").data(kStruckRole).toBool());
  EXPECT_TRUE(model_.indexOf("vision/camera/Video").data(kStaleRole).toBool());
  EXPECT_FALSE(model_.indexOf("robot/arm").data(kStaleRole).toBool());
}

TEST_F(CatalogueModelTest, MarksNewComponentsForTenSeconds) {
  SystemBuilder system = LookSystem(0);
  model_.setNow(100 * kSecond);
  Show(system);
  EXPECT_FALSE(model_.indexOf("robot/arm").data(kFreshRole).toBool()) << "all has just come";

  model_.setNow(120 * kSecond);
  ComponentDescription other = *system.catalogue().FindComponent("robot", "arm");
  other.name = "left_arm";
  system.Component("robot", other);
  Show(system);
  EXPECT_TRUE(model_.indexOf("robot/left_arm").data(kFreshRole).toBool());
  EXPECT_FALSE(model_.indexOf("robot/arm").data(kFreshRole).toBool());

  model_.setNow(129 * kSecond);
  EXPECT_TRUE(model_.indexOf("robot/left_arm").data(kFreshRole).toBool());
  model_.setNow(130 * kSecond);
  EXPECT_FALSE(model_.indexOf("robot/left_arm").data(kFreshRole).toBool());
}

TEST_F(CatalogueModelTest, DoesNotMarkComponentsAfterAGcmRestart) {
  SystemBuilder system = LookSystem(0);
  model_.setNow(100 * kSecond);
  Show(system);

  model_.setNow(200 * kSecond);
  model_.setOutdated(true);
  store_.replace({});
  store_.replace(LookSystem(0).catalogue());
  EXPECT_FALSE(model_.indexOf("robot/arm").data(kFreshRole).toBool()) << "it tells what it knows";

  store_.replace({});
  model_.setOutdated(false);
  model_.setNow(205 * kSecond);
  store_.replace(LookSystem(0).catalogue());
  EXPECT_FALSE(model_.indexOf("robot/arm").data(kFreshRole).toBool()) << "all join it again";
}

TEST_F(CatalogueModelTest, AValueExpandsItsColumnIntoFieldsAndElements) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  ASSERT_EQ(model_.rowCount(model_.indexOf("robot/arm/state.Joints")), 0);

  ScriptedSignals source;
  QObject::connect(&source, &SignalSource::valuesArrived, &model_, &CatalogueModel::showValues);
  source.send("robot/arm/state.Joints", test::JointStateSchema(2), {0.2013, -0.3987, 0, 1});

  EXPECT_EQ(Value("robot/arm/state.Joints.position[0]"), "0.2013");
  EXPECT_EQ(Value("robot/arm/state.Joints.position[1]"), "-0.3987");
  EXPECT_EQ(model_.indexOf("robot/arm/state.Joints.position").siblingAtColumn(1).data(kUnitRole),
            "rad");
  const QList<CurveKey> keys = model_.signalsBelow("robot/arm/state.Joints.velocity");
  ASSERT_EQ(keys.size(), 2);
  EXPECT_EQ(keys[1], (CurveKey{"robot/arm/state.Joints.velocity[1]", "rad/s"}));
}

TEST_F(CatalogueModelTest, ShowsDurationsInAFittingUnit) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  ScriptedSignals source;
  QObject::connect(&source, &SignalSource::valuesArrived, &model_, &CatalogueModel::showValues);
  SendSummary(source, "robot/arm", {1000, 1e-3, 19.56e-6, 0, 0, 0});
  const auto unit = [this](const QString& path) {
    return model_.indexOf(path).siblingAtColumn(1).data(kUnitRole).toString();
  };

  const QString lateness = "robot/arm/state.CycleSummary.lateness";
  EXPECT_EQ(Value(lateness + ".p50"), "19.6");
  EXPECT_EQ(unit(lateness + ".p50"), "µs");
  EXPECT_EQ(unit(lateness), "s");
  EXPECT_EQ(unit(lateness + ".max"), "") << "told above";
  EXPECT_EQ(model_.signalsBelow(lateness).front().unit, "s") << "plots keep that of the channel";
}

TEST_F(CatalogueModelTest, NewValuesInsertNoRows) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  ScriptedSignals source;
  QObject::connect(&source, &SignalSource::valuesArrived, &model_, &CatalogueModel::showValues);
  source.send("robot/arm/state.Joints", test::JointStateSchema(2), {1, 2, 3, 4});
  QSignalSpy inserted(&model_, &QAbstractItemModel::rowsInserted);
  QSignalSpy changed(&model_, &QAbstractItemModel::dataChanged);

  source.send("robot/arm/state.Joints", test::JointStateSchema(2), {5, 6, 7, 8});

  EXPECT_EQ(inserted.count(), 0);
  EXPECT_GT(changed.count(), 0);
  EXPECT_EQ(Value("robot/arm/state.Joints.position[0]"), "5");
}

TEST_F(CatalogueModelTest, RowsSurviveAProcessRestart) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  const QPersistentModelIndex arm = model_.indexOf("robot/arm");
  const ComponentDescription description = *system.catalogue().FindComponent("robot", "arm");

  system.Process("robot", ProcessState::kLost, kSecond);
  Show(system);
  system.Process("robot", ProcessState::kAlive, 0, 2).Component("robot", description);
  Show(system);

  ASSERT_TRUE(arm.isValid());
  EXPECT_EQ(QModelIndex(arm), model_.indexOf("robot/arm"));
  EXPECT_FALSE(arm.data(kStaleRole).toBool());
}

TEST_F(CatalogueModelTest, AConnectionChangesTheRowsOfBothEndsOnly) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  QSignalSpy inserted(&model_, &QAbstractItemModel::rowsInserted);
  QSignalSpy removed(&model_, &QAbstractItemModel::rowsRemoved);

  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  Show(system);

  EXPECT_EQ(Value("desk/teleoperation/Robot"), "← controller/Control");
  EXPECT_EQ(Value("robot/controller/Control"), "1 client");
  EXPECT_EQ(inserted.count() + removed.count(), 0);
}

TEST_F(CatalogueModelTest, ASnapshotRemovesStaleRows) {
  SystemBuilder system = LookSystem(0);
  Show(system);
  SystemBuilder other;
  other.Process("gcm");

  store_.replace(other.catalogue());

  EXPECT_EQ(model_.rowCount({}), 1);
  EXPECT_FALSE(model_.indexOf("robot/arm").isValid());
  EXPECT_EQ(model_.itemCount(), 1);
}

/// Applies random changes. QAbstractItemModelTester aborts on the first inconsistency.
TEST_F(CatalogueModelTest, FollowsRandomChangesLikeANewModel) {
  SystemBuilder system;
  std::mt19937 random(20261121);
  const auto pick = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const auto process = [&] { return "p" + std::to_string(pick(4)); };
  const auto component = [&] { return "c" + std::to_string(pick(5)); };
  for (int step = 0; step < 600; ++step) {
    switch (pick(8)) {
      case 0:
        system.Process(process(), pick(2) == 0 ? ProcessState::kLost : ProcessState::kAlive, step,
                       static_cast<std::uint64_t>(pick(3)));
        break;
      case 1:
        system.RemoveProcess(process());
        break;
      case 2:
        system.RemoveComponent(process(), component());
        break;
      case 3:
        system.Connect({process(), component(), "Arm"}, {process(), component(), "state"});
        break;
      case 4:
        system.Disconnect({process(), component(), "Arm"});
        break;
      default: {
        std::vector<ColumnDescription> columns;
        for (int i = pick(3); i >= 0; --i) columns.push_back(Column("x" + std::to_string(i), "t"));
        ComponentDescription task = Task(component(), 1e-3, columns);
        if (pick(2) == 0) task.required.push_back({"Arm", {Read("Get", "t")}, {}, false});
        system.Component(process(), task);
      }
    }
    if (pick(3) == 0) Show(system);
    const ColumnValues values{std::make_shared<const std::vector<NumericField>>(
                                  NumericFields(test::JointStateSchema(1 + step % 3))),
                              {},
                              {}};
    model_.showValues(QString::fromStdString(process() + "/" + component() + "/state.x1"), values);
  }
  Show(system);

  CatalogueModel fresh;
  ChangedParts all;
  for (const auto& [name, entry] : system.catalogue().processes()) all.insert({name, {}});
  fresh.update(system.catalogue(), all);
  EXPECT_EQ(model_.itemCount(), fresh.itemCount());
  EXPECT_EQ(model_.rowCount({}), fresh.rowCount({}));
}

}  // namespace
}  // namespace tendon::gui
