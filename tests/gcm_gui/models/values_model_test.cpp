#include <gcm_gui/inspector/cycle_figures.h>
#include <gcm_gui/inspector/interfaces_model.h>
#include <gcm_gui/inspector/values_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

TEST(ValuesModel, ShowsEveryNumberOfTheComponentOnceItHasCome) {
  ValuesModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  ScriptedSignals source;
  QObject::connect(&source, &SignalSource::valuesArrived, &model, &ValuesModel::showValues);
  const Catalog catalogue = LookSystem(0).catalog();
  model.show("robot/arm", catalogue.FindComponent("robot", "arm"), false);
  EXPECT_EQ(model.rowCount(), 0);
  EXPECT_EQ(model.columns(), (QSet<QString>{"robot/arm/state.Joints", "robot/arm/state.Cycle"}));

  source.send("robot/arm/state.Joints", JointSchema(3), {0.5, 0, 0, 1, 0, 0});

  EXPECT_EQ(model.rowCount(), 6);
  EXPECT_EQ(model.index(0, 0).data(), "Joints.position[0]");
  EXPECT_EQ(model.index(0, 1).data(), "0.5000");
  EXPECT_EQ(model.index(3, 1).data(kUnitRole), "rad/s");
  EXPECT_EQ(model.index(3, 0).data(kPathRole), "robot/arm/state.Joints.velocity[0]");
}

TEST(InterfacesModel, ShowsMembersWithTypesAndWhatEachInterfaceIsConnectedTo) {
  InterfacesModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);

  model.show(LookSystem(0).catalog(), "robot", "controller");

  EXPECT_EQ(model.row(0).name, "Arm");
  EXPECT_EQ(model.row(0).value, "connected");
  EXPECT_EQ(model.row(1).kind, InterfaceRow::Kind::kPeer);
  EXPECT_EQ(model.row(1).name, "← arm/Drives");
  EXPECT_EQ(model.row(2).name, "SetTorques");
  EXPECT_EQ(model.row(2).types, "JointTorques");
}

TEST(InterfacesModel, APeerOfAnotherProcessNamesIt) {
  InterfacesModel model;
  SystemBuilder system = LookSystem(0);
  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});

  model.show(system.catalog(), "desk", "teleoperation");

  EXPECT_EQ(model.row(1).name, "← controller/Control");
  EXPECT_EQ(model.row(1).types, "robot");
  EXPECT_EQ(model.row(1).path, "robot/controller/Control");
}

TEST(InterfacesModel, AProvidedInterfaceListsItsClients) {
  InterfacesModel model;

  model.show(LookSystem(0).catalog(), "robot", "arm");

  EXPECT_EQ(model.row(0).value, "1 client");
  EXPECT_EQ(model.row(1).name, "→ controller/Arm");
  EXPECT_EQ(model.row(1).required, (InterfaceName{"robot", "controller", "Arm"}));
}

TEST(CycleFigures, TellsPeriodOverrunsAndTheSpreadOfLateness) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");
  ASSERT_TRUE(source.subscribed.contains("robot/arm/state.Cycle.lateness"));
  std::vector<Sample> samples;
  for (int i = 0; i <= 100; ++i) samples.push_back({0, 0, i * 1e-6});

  source.send("robot/arm/state.Cycle", CycleSchema(), {1e-3, 2e-6, 38e-6, 4});
  Q_EMIT source.samplesArrived("robot/arm/state.Cycle.lateness", samples);

  EXPECT_DOUBLE_EQ(figures.period(), 1e-3);
  EXPECT_DOUBLE_EQ(figures.compute(), 38e-6);
  EXPECT_EQ(figures.overruns(), 4u);
  EXPECT_DOUBLE_EQ(figures.lateness(0.5).value(), 50e-6);
  EXPECT_DOUBLE_EQ(figures.lateness(0.99).value(), 99e-6);
}

TEST(CycleFigures, LetsGoOfTheComponentBefore) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");

  figures.show({});

  EXPECT_TRUE(source.subscribed.isEmpty());
  EXPECT_TRUE(source.watched().isEmpty());
  EXPECT_FALSE(figures.known());
}

}  // namespace
}  // namespace tendon::gui
