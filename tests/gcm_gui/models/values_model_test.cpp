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
  EXPECT_EQ(model.columns(), (QSet<QString>{"robot/arm/state.Joints", "robot/arm/state.Cycle",
                                            "robot/arm/state.CycleSummary"}));

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

TEST(CycleFigures, TellsOfTheLastSecondAndWhatWasSkipped) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");
  EXPECT_EQ(source.watched(),
            (QSet<QString>{"robot/arm/state.Cycle", "robot/arm/state.CycleSummary"}));

  source.send("robot/arm/state.Cycle", CycleSchema(), {54e-6, 2e-6, 38e-6, 4});
  SendSummary(source, "robot/arm", {878, 1.139e-3, 35e-6, 3e-3, 52e-3, 42e-6});

  EXPECT_EQ(figures.skipped(), 4u);
  ASSERT_TRUE(figures.lastSecond().has_value());
  EXPECT_DOUBLE_EQ(figures.lastSecond()->period, 1.139e-3);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->late, 35e-6);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->later, 3e-3);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->latest, 52e-3);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->compute, 42e-6);
}

TEST(CycleFigures, SayNothingBeforeASecondIsOver) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");

  SendSummary(source, "robot/arm", {});

  EXPECT_FALSE(figures.lastSecond().has_value());
  EXPECT_FALSE(figures.skipped().has_value());
}

TEST(CycleFigures, LetsGoOfTheComponentBefore) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");

  figures.show({});

  EXPECT_TRUE(source.watched().isEmpty());
  EXPECT_FALSE(figures.skipped().has_value());
}

}  // namespace
}  // namespace tendon::gui
