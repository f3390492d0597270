#include <gcm_gui/models/connections_model.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

TEST(ConnectionsModel, HasOneSortedRowPerConnection) {
  ConnectionsModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);

  model.update(LookSystem(0).catalogue());

  ASSERT_EQ(model.rowCount({}), 3);
  EXPECT_EQ(model.index(0, ConnectionsModel::kRequired).data(), "desk/view/Host");
  EXPECT_EQ(model.index(0, ConnectionsModel::kProvided).data(), "desk/host_monitor/state");
  EXPECT_EQ(model.index(0, ConnectionsModel::kState).data(), "connected");
}

TEST(ConnectionsModel, InsertsAndRemovesOnlyChangedRows) {
  ConnectionsModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  SystemBuilder system = LookSystem(0);
  model.update(system.catalogue());
  QSignalSpy inserted(&model, &QAbstractItemModel::rowsInserted);
  QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);

  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  system.Disconnect({"robot", "controller", "Force"});
  model.update(system.catalogue());

  EXPECT_EQ(inserted.count(), 1);
  EXPECT_EQ(removed.count(), 1);
  EXPECT_EQ(model.rowOf("desk/teleoperation/Robot"), 0);
}

TEST(ConnectionsModel, ShowsTheReasonOfAFailedConnection) {
  ConnectionsModel model;
  SystemBuilder system = LookSystem(0);
  system.Connect({"desk", "view", "Host"}, {"desk", "host_monitor", "state"},
                 ConnectionState::kFailed, "no reply in 2 s");
  model.update(system.catalogue());

  EXPECT_EQ(model.index(0, ConnectionsModel::kState).data(), "refused · no reply in 2 s");
}

}  // namespace
}  // namespace tendon::gui
