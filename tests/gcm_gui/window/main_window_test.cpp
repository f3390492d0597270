#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/connect/candidate_list.h>
#include <gcm_gui/connect/candidate_panel.h>
#include <gcm_gui/console/console_page.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/session/link_state.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/lost_banner.h>
#include <gcm_gui/window/main_window.h>
#include <gcm_gui/window/notice_line.h>
#include <gcm_gui/window/top_bar.h>
#include <gtest/gtest.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class MainWindowTest : public WindowFixture {
 protected:
  QString Notice() const { return window_.findChild<NoticeLine*>()->text(); }
};

QLabel* Label(const MainWindow& window, const char* name) {
  return window.findChild<QLabel*>(name);
}

TEST_F(MainWindowTest, TheBarShowsTheGcmStateAndCounts) {
  EXPECT_EQ(window_.topBar().linkText(),
            "Hosting the GCM on this machine 2 processes · 6 components · 3 connections");

  link_.setUnreachable("127.0.0.1:10705 refused");

  EXPECT_TRUE(window_.topBar().linkText().startsWith("GCM lost"));
}

TEST_F(MainWindowTest, F5ReloadsEverything) {
  QSignalSpy asked(&link_, &LinkState::resyncRequested);

  QTest::keyClick(&window_, Qt::Key_F5);

  EXPECT_EQ(asked.count(), 1);
  EXPECT_EQ(Notice(), "Everything is loaded from the GCM again");
}

TEST_F(MainWindowTest, TheBarDoesNotCountProcessesThatLeft) {
  system_.Process("desk", ProcessState::kLeft);
  Show();

  EXPECT_EQ(window_.topBar().linkText(),
            "Hosting the GCM on this machine 1 process · 3 components · 2 connections");
}

TEST_F(MainWindowTest, WithoutAGcmTheWindowShowsThatItsDataIsOld) {
  const auto* banner = window_.findChild<LostBanner*>();
  const QModelIndex arm = window_.catalogueModel().indexOf("robot/arm");
  EXPECT_FALSE(banner->isVisible());

  link_.setUnreachable("127.0.0.1:10705 refused");

  EXPECT_TRUE(banner->isVisible());
  EXPECT_TRUE(banner->text().startsWith("Grey parts show the state of "))
      << banner->text().toStdString();
  EXPECT_TRUE(arm.data(kStaleRole).toBool());
  EXPECT_TRUE(window_.graph().graph().component("robot/arm")->isStale());

  link_.setConnected();

  EXPECT_TRUE(Notice().startsWith("The GCM is back after ")) << Notice().toStdString();
  EXPECT_FALSE(banner->isVisible());
  EXPECT_FALSE(arm.data(kStaleRole).toBool());
  EXPECT_FALSE(window_.graph().graph().component("robot/arm")->isStale());
}

TEST_F(MainWindowTest, ValuesContinueWithoutTheGcm) {
  source_.send("robot/arm/state.Joints", test::JointStateSchema(2), {1, 2, 3, 4});

  link_.setUnreachable("127.0.0.1:10705 refused");

  const QModelIndex value = window_.catalogueModel().indexOf("robot/arm/state.Joints.position[0]");
  EXPECT_FALSE(value.data(kStaleRole).toBool());
}

TEST_F(MainWindowTest, AllViewsShareOneSelection) {
  window_.catalogue().tree().reveal("robot/arm/Drives");
  const QRect row = window_.catalogue().tree().visibleRows().value("robot/arm");
  ASSERT_FALSE(row.isEmpty());
  QTest::mouseClick(window_.catalogue().tree().viewport(), Qt::LeftButton, {}, row.center());
  EXPECT_EQ(window_.selection().current(), "robot/arm");
  EXPECT_EQ(Label(window_, "inspector.name")->text(), "arm");

  window_.selection().select("desk/view");
  EXPECT_EQ(Label(window_, "inspector.name")->text(), "view");
  const auto rows = window_.catalogue().tree().selectionModel()->selectedRows();
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows.front().data().toString(), "view");
}

TEST_F(MainWindowTest, TwoClicksInTheGraphConnectAndCtrlZUndoes) {
  const auto click = [&](const PortName& port) {
    GraphView& graph = window_.graph();
    QTest::mouseClick(graph.viewport(), Qt::LeftButton, {}, graph.pointOf(port).value());
  };
  click({Side::kRequired, {"desk", "teleoperation", "Robot"}});
  EXPECT_TRUE(Notice().contains("desk/teleoperation/Robot"));
  click({Side::kProvided, {"robot", "controller", "Control"}});
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);

  EXPECT_EQ(actions_.asked,
            (QStringList{"connect desk/teleoperation/Robot robot/controller/Control", "undo"}));
}

TEST_F(MainWindowTest, CThenEnterConnects) {
  window_.selection().select("desk/teleoperation");

  QTest::keyClick(&window_, Qt::Key_C);
  QTest::keyClick(&window_.graph(), Qt::Key_Return);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(MainWindowTest, TheTabKeyGoesFromLeftToRight) {
  window_.selection().select("robot/controller");
  QWidget* start = window_.findChild<QPushButton*>("theme");
  start->setFocus();
  QStringList way;
  for (int step = 0; step < 60; ++step) {
    QTest::keyClick(window_.focusWidget(), Qt::Key_Tab);
    if (window_.focusWidget() == start) break;
    way.append(window_.focusWidget()->objectName());
  }

  qsizetype last = -1;
  for (const char* name : {"filter", "catalogue", "centre.tabs", "graph", "plotTabs", "canvas",
                           "inspectorTabs.tabs", "inspector.interfaces", "replace", "strip.tabs"}) {
    EXPECT_GT(way.indexOf(name), last) << name << " in " << qPrintable(way.join(' '));
    last = way.indexOf(name);
  }
}

TEST_F(MainWindowTest, TheOtherEndCanBePickedInTheTree) {
  CatalogueTree& tree = window_.catalogue().tree();
  tree.reveal("robot/controller/Control");
  window_.selection().select("desk/teleoperation");
  QTest::keyClick(&window_, Qt::Key_C);

  const QRect row = tree.visibleRows().value("robot/controller/Control");
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, row.center());

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(MainWindowTest, ConnectModeListsTheCandidates) {
  window_.selection().select("desk/teleoperation");
  QTest::keyClick(&window_, Qt::Key_C);

  CandidatePanel& candidates = window_.candidates();
  ASSERT_TRUE(candidates.isVisible());
  EXPECT_TRUE(candidates.filterField().hasFocus());
  QTest::keyClicks(&candidates.filterField(), "drives");
  QTest::keyClick(&candidates.filterField(), Qt::Key_Return);
  EXPECT_TRUE(Notice().contains("pick a provided interface · Esc cancels"));
  EXPECT_TRUE(actions_.asked.isEmpty());  // the port does not fit

  candidates.filterField().clear();
  QTest::keyClick(&candidates.filterField(), Qt::Key_Return);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
  EXPECT_FALSE(candidates.isVisible());
}

TEST_F(MainWindowTest, ADigitInTheListPicksAndEscapeLeaves) {
  window_.selection().select("desk/teleoperation");
  QTest::keyClick(&window_, Qt::Key_C);
  QTest::keyClick(&window_.candidates().filterField(), Qt::Key_Escape);
  EXPECT_FALSE(window_.connectMode().active());

  QTest::keyClick(&window_, Qt::Key_C);
  QTest::keyClick(&window_.candidates().filterField(), Qt::Key_1);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(MainWindowTest, ACandidateCanBeClicked) {
  window_.selection().select("desk/teleoperation");
  QTest::keyClick(&window_, Qt::Key_C);
  CandidateList& list = window_.candidates().list();

  QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                    list.visualRect(list.model()->index(0, 0)).center());

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(MainWindowTest, CtrlDigitsSwitchPerspectives) {
  const QSize graph = window_.graph().size();

  QTest::keyClick(&window_, Qt::Key_2, Qt::ControlModifier);
  EXPECT_FALSE(window_.inspector().isVisible());
  EXPECT_FALSE(window_.strip().isVisible());
  EXPECT_GT(window_.plots().height(), window_.graph().height());

  QTest::keyClick(&window_, Qt::Key_1, Qt::ControlModifier);
  EXPECT_TRUE(window_.inspector().isVisible());
  EXPECT_TRUE(window_.strip().isVisible());
  EXPECT_EQ(window_.graph().width(), graph.width());
}

TEST_F(MainWindowTest, SavesAndRestoresALayout) {
  window_.panels().show(Panels::Perspective::kPlot);
  const QByteArray kept = window_.panels().state();
  window_.panels().reset();
  ASSERT_TRUE(window_.inspector().isVisible());

  window_.panels().restore(kept);
  EXPECT_FALSE(window_.inspector().isVisible());

  window_.panels().restore("no layout");
  EXPECT_FALSE(window_.inspector().isVisible());
}

TEST_F(MainWindowTest, DDisconnectsTheSelectedInterface) {
  window_.selection().select("robot/controller/Arm");

  QTest::keyClick(&window_, Qt::Key_D);

  EXPECT_EQ(actions_.asked, QStringList{"disconnect robot/controller/Arm"});
}

TEST_F(MainWindowTest, TheInspectorDisconnectsAnInterface) {
  window_.selection().select("robot/controller");
  auto* button = window_.inspector().findChild<QToolButton*>("disconnect");
  ASSERT_NE(button, nullptr);

  QTest::mouseClick(button, Qt::LeftButton);

  EXPECT_EQ(actions_.asked, QStringList{"disconnect robot/controller/Arm"});
}

TEST_F(MainWindowTest, PPlotsTheSelectionAndRowsReachTheCurve) {
  source_.send("robot/arm/state.Joints", test::JointStateSchema(2), {1, 2, 3, 4});
  window_.selection().select("robot/arm/state.Joints.position");

  QTest::keyClick(&window_, Qt::Key_P);

  EXPECT_TRUE(source_.subscribed.contains("robot/arm/state.Joints.position[0]"));
  EXPECT_TRUE(source_.subscribed.contains("robot/arm/state.Joints.position[1]"));
  EXPECT_FALSE(source_.subscribed.contains("robot/arm/state.Joints.velocity[0]"));
  const std::vector<Sample> samples{{1, 1, 0.5}, {2, 2, 0.75}};
  Q_EMIT source_.samplesArrived("robot/arm/state.Joints.position[0]", samples);
  const auto& curves = window_.plots().currentPlot().curves();
  EXPECT_EQ(curves.find("robot/arm/state.Joints.position[0]")->latestNumber(), 0.75);
}

TEST_F(MainWindowTest, ADoubleClickOnAValuePlotsIt) {
  source_.send("robot/arm/state.Joints", test::JointStateSchema(2), {1, 2, 3, 4});
  CatalogueTree& tree = window_.catalogue().tree();
  tree.reveal("robot/arm/state.Joints.position[1]");
  const QRect row = tree.visibleRows().value("robot/arm/state.Joints.position[1]");
  ASSERT_FALSE(row.isEmpty());

  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, row.center());
  QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, row.center());

  EXPECT_EQ(window_.plots().paths(), QStringList{"robot/arm/state.Joints.position[1]"});
}

TEST_F(MainWindowTest, PlottingANonNumberGivesANotice) {
  window_.selection().select("robot/arm");

  QTest::keyClick(&window_, Qt::Key_P);

  EXPECT_TRUE(window_.plots().paths().isEmpty());
  EXPECT_TRUE(Notice().contains("is not a number"));
}

TEST_F(MainWindowTest, OnlyVisibleColumnsAreSubscribed) {
  EXPECT_TRUE(source_.watched().isEmpty());

  window_.catalogue().tree().reveal("robot/arm/state.Joints");
  EXPECT_TRUE(QTest::qWaitFor([&] { return source_.watched().contains("robot/arm/state.Joints"); },
                              kTestTimeout));

  window_.catalogue().tree().collapse(
      window_.catalogue().tree().model()->index(1, 0));  // the row of robot; desk comes first
  EXPECT_TRUE(QTest::qWaitFor([&] { return source_.watched().isEmpty(); }, kTestTimeout));
}

TEST_F(MainWindowTest, SpacePausesTheView) {
  auto* pause = window_.findChild<QPushButton*>("pause");

  QTest::keyClick(&window_, Qt::Key_Space);
  EXPECT_TRUE(window_.plots().isPaused());
  EXPECT_EQ(pause->accessibleName(), "Resume view");

  QTest::mouseClick(pause, Qt::LeftButton);
  EXPECT_FALSE(window_.plots().isPaused());
}

TEST_F(MainWindowTest, CtrlFFocusesTheFilter) {
  QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);
  QTest::keyClicks(&window_.catalogue().filterField(), "type:required");
  QTest::keyClick(&window_.catalogue().filterField(), Qt::Key_Return);

  EXPECT_FALSE(window_.catalogue().tree().visibleRows().contains("robot/arm"));
  EXPECT_TRUE(window_.catalogue().tree().visibleRows().contains("robot/controller/Arm"));

  QTest::keyClick(&window_.catalogue().filterField(), Qt::Key_Escape);
  EXPECT_TRUE(window_.catalogue().tree().visibleRows().contains("robot/arm"));
}

TEST_F(MainWindowTest, TypingInTheFilterTriggersNoShortcut) {
  QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);

  QTest::keyClicks(&window_.catalogue().filterField(), "pcd ");

  EXPECT_EQ(window_.catalogue().filterField().text(), "pcd ");
  EXPECT_TRUE(actions_.asked.isEmpty());
  EXPECT_FALSE(window_.plots().isPaused());
}

TEST_F(MainWindowTest, AListedActionCanBeUndoneAndCopied) {
  Action action;
  action.required = {"desk", "teleoperation", "Robot"};
  action.provided = {"robot", "controller", "Control"};
  activity_.finish(activity_.begin(action), 0.038, {});

  QTest::mouseClick(window_.strip().findChild<QToolButton*>("copyCommand"), Qt::LeftButton);
  QTest::mouseClick(window_.strip().findChild<QToolButton*>("undo"), Qt::LeftButton);

  EXPECT_EQ(QGuiApplication::clipboard()->text(),
            "gcm connect desk/teleoperation/Robot robot/controller/Control");
  EXPECT_EQ(actions_.asked, QStringList{"undo"});
  EXPECT_EQ(Notice(), "Connected in 38.00 ms · Ctrl+Z undoes");
}

TEST_F(MainWindowTest, RestoresOpenRowsAndSelectionAfterAProcessRestart) {
  CatalogueTree& tree = window_.catalogue().tree();
  tree.reveal("robot/arm/Drives.GetJoints");
  window_.selection().select("robot/arm/Drives.GetJoints");
  const ComponentDescription arm = *system_.catalogue().FindComponent("robot", "arm");

  system_.Process("robot", ProcessState::kLost, 1);
  Show();
  system_.Process("robot", ProcessState::kAlive, 0, 2);
  Show();  // the restarted process has no components for a moment
  EXPECT_FALSE(tree.visibleRows().contains("robot/arm"));
  system_.Component("robot", arm);
  Show();

  EXPECT_TRUE(tree.visibleRows().contains("robot/arm/Drives.GetJoints"));
  EXPECT_EQ(window_.selection().current(), "robot/arm/Drives.GetJoints");
  EXPECT_EQ(tree.selectionModel()->selectedRows().size(), 1);
  EXPECT_EQ(Label(window_, "inspector.name")->text(), "arm");
}

TEST_F(MainWindowTest, ValuesResumeInTheTreeWhenAProcessReturns) {
  const QString column = "robot/arm/state.Joints";
  const auto watched = [&] { return source_.watched().contains(column); };
  window_.catalogue().tree().reveal(column);
  ASSERT_TRUE(QTest::qWaitFor(watched, kTestTimeout));
  system_.Process("robot", ProcessState::kLost, 1);
  Show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !watched(); }, kTestTimeout));

  system_.Process("robot");
  Show();

  EXPECT_TRUE(QTest::qWaitFor(watched, kTestTimeout));
}

TEST_F(MainWindowTest, WrapsALongReason) {
  window_.selection().select("vision");
  QLabel* reason = nullptr;
  for (auto* label : window_.inspector().findChildren<QLabel*>()) {
    if (label->accessibleName() == "Reason") reason = label;
  }
  ASSERT_NE(reason, nullptr);
  EXPECT_EQ(reason->text(), "its connection broke");
  const int line = reason->height();

  system_.Process("vision", ProcessState::kLost, 2, 1,
                  "its connection broke: 127.0.0.1:51678 closed the connection, and nothing has "
                  "been heard of it since");
  Show();

  EXPECT_TRUE(QTest::qWaitFor([&] { return reason->height() > 2 * line; }, kTestTimeout));
}

TEST_F(MainWindowTest, ALostProcessCanBeForgotten) {
  window_.selection().select("vision");

  QTest::mouseClick(window_.findChild<QPushButton*>("forget"), Qt::LeftButton);

  EXPECT_EQ(actions_.asked, QStringList{"forget vision"});
}

TEST_F(MainWindowTest, ShowsNoticesOfTheConsole) {
  Q_EMIT window_.strip().console().notice("console was not saved: the disk is full");

  EXPECT_EQ(Notice(), "console was not saved: the disk is full");
}

TEST_F(MainWindowTest, ShowsTheEmptyStateWithNoProcess) {
  store_.replace(Catalogue::At(0));

  EXPECT_FALSE(window_.graph().isVisible());
  EXPECT_TRUE(window_.findChild<QWidget*>("emptyState")->isVisible());
}

TEST_F(MainWindowTest, EveryButtonHasAName) {
  for (const auto* button : window_.findChildren<QAbstractButton*>()) {
    if (!button->isVisible()) continue;
    const bool named = !button->accessibleName().isEmpty() || !button->text().isEmpty() ||
                       !button->toolTip().isEmpty();
    EXPECT_TRUE(named) << button->metaObject()->className() << " "
                       << button->objectName().toStdString();
  }
}

}  // namespace
}  // namespace tendon::gui
