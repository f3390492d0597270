#include <gcm_gui/commands/graph_commands.h>
#include <gcm_gui/graph/graph_export.h>
#include <gcm_gui/graph/graph_map.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMenu>
#include <QTest>

#include "support/folder.h"
#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class GraphCommandsTest : public WindowFixture {
 protected:
  [[nodiscard]] QString Said() const { return window_.findChild<NoticeLine*>()->text(); }
  [[nodiscard]] QString InFolder(const char* name) const {
    return QString::fromStdString((folder_.path() / name).string());
  }
  [[nodiscard]] GraphExport& exporter() const { return *window_.findChild<GraphExport*>(); }

  /// Saves the graph to `file`, waits for the notice, and returns the content.
  QByteArray Saved(const QString& file) {
    exporter().save(file);
    EXPECT_TRUE(QTest::qWaitFor([&] { return Said() == file + " saved"; }, kTestTimeout))
        << Said().toStdString();
    QFile written(file);
    EXPECT_TRUE(written.open(QIODevice::ReadOnly));
    return written.readAll();
  }

  const test::Folder folder_;
};

TEST_F(GraphCommandsTest, MShowsAndHidesTheMap) {
  GraphMap& map = window_.graphCommands().map();
  for (int step = 0; step < 6; ++step) QTest::keyClick(&window_.graph(), Qt::Key_Plus);
  ASSERT_TRUE(map.isVisible());

  QTest::keyClick(&window_, Qt::Key_M);
  EXPECT_FALSE(map.isVisible());

  QTest::keyClick(&window_, Qt::Key_M);
  EXPECT_TRUE(map.isVisible());
}

TEST_F(GraphCommandsTest, TheContextMenuSavesAPicture) {
  QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5},
                          window_.graph().viewport()->mapToGlobal(QPoint(5, 5)));
  QApplication::sendEvent(window_.graph().viewport(), &event);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_NE(menu, nullptr);
  auto* save = menu->findChild<QAction*>("Save a picture of the graph");
  ASSERT_NE(save, nullptr);

  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(save).center());

  auto* dialog = window_.findChild<QFileDialog*>("graphExport");
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->isVisible());
  const QString file = InFolder("chosen");
  dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
  QTest::keyClick(dialog->findChild<QLineEdit*>("fileNameEdit"), Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return QFile::exists(file + ".svg"); }, kTestTimeout));
}

TEST_F(GraphCommandsTest, CtrlZUndoesAMoveUntilAnotherAction) {
  GraphScene& scene = window_.graph().graph();
  const auto place = [&] { return scene.component("robot/arm")->sceneRect().topLeft(); };
  const QPointF before = place();
  window_.selection().select("robot/arm");
  window_.graph().setFocus();
  QTest::keyClick(&window_.graph(), Qt::Key_Down, Qt::AltModifier);
  ASSERT_NE(place(), before);

  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(place(), before);
  EXPECT_EQ(Said(), "Moved back");
  EXPECT_TRUE(actions_.asked.isEmpty());

  QTest::keyClick(&window_.graph(), Qt::Key_Down, Qt::AltModifier);
  activity_.finish(activity_.begin(Action()), 0.01, {});
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(actions_.asked, QStringList{"undo"});
  EXPECT_NE(place(), before);

  window_.findChild<QAction*>("Reset the layout of the graph")->trigger();
  EXPECT_EQ(place(), before);
}

TEST_F(GraphCommandsTest, TheSystemFileSavesAndRestoresPositions) {
  GraphScene& scene = window_.graph().graph();
  const auto place = [&] { return scene.component("robot/arm")->sceneRect().topLeft(); };
  const QPointF before = place();
  scene.nodePositions().move({{"robot/arm", {-120, 44}}, {"gone/thing", {1, 2}}});
  SystemDocument& document = window_.files().document();
  const QString file = InFolder("put.gcm.json");
  document.save(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document.isOpen(); }, kTestTimeout));
  const auto read = ReadSystemFile(file.toStdString());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->layout.size(), 1U);
  EXPECT_EQ(read->layout.at("robot/arm"), (SystemFile::Position{-120, 44}));

  scene.nodePositions().reset();
  ASSERT_EQ(place(), before);
  document.open(file);

  EXPECT_TRUE(QTest::qWaitFor([&] { return place() == QPointF(-120, 44); }, kTestTimeout));
}

TEST_F(GraphCommandsTest, CtrlFSearchesTheFocusedView) {
  GraphSearch& search = window_.graphCommands().search();
  window_.graph().setFocus();
  QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);
  EXPECT_TRUE(search.field().hasFocus());
  QTest::keyClicks(&search.field(), "view");
  QTest::keyClick(&search.field(), Qt::Key_Return);
  EXPECT_EQ(window_.selection().current(), "desk/view");

  QTest::keyClick(&search.field(), Qt::Key_Escape);
  EXPECT_FALSE(search.isVisible());
  EXPECT_TRUE(window_.graph().hasFocus());

  window_.catalogue().tree().setFocus();
  QTest::keyClick(&window_, Qt::Key_F, Qt::ControlModifier);
  EXPECT_TRUE(window_.catalogue().filterField().hasFocus());
  window_.catalogue().tree().setFocus();
  QTest::keyClick(&window_, Qt::Key_Slash);
  EXPECT_TRUE(search.field().hasFocus());
}

TEST_F(GraphCommandsTest, SvgAndDotMatchTheConsole) {
  const QByteArray svg = Saved(InFolder("system.svg"));
  EXPECT_TRUE(svg.startsWith("<svg "));
  EXPECT_TRUE(svg.contains(">controller</text>"));

  const QByteArray dot = Saved(InFolder("system.dot"));
  EXPECT_TRUE(dot.startsWith("digraph system {"));
  EXPECT_TRUE(dot.contains(R"("robot/controller" -> "robot/arm" [label="Arm -> Drives"])"));
}

TEST_F(GraphCommandsTest, SvgAndDotUseMovedPositions) {
  GraphScene& scene = window_.graph().graph();
  const QByteArray before = Saved(InFolder("before.svg"));
  scene.nodePositions().move(
      {{"robot/arm",
        scene.component("robot/force_sensor")->sceneRect().topLeft() + QPointF(0, 200)}});

  const QByteArray svg = Saved(InFolder("after.svg"));
  const auto height_of = [](const QByteArray& picture, const QByteArray& name) {
    const qsizetype end = picture.indexOf('>' + name + "</text>");
    const qsizetype start = picture.lastIndexOf(" y=\"", end) + 4;
    return picture.mid(start, picture.indexOf('"', start) - start).toDouble();
  };
  EXPECT_NE(svg, before);
  EXPECT_GT(height_of(svg, "arm"), height_of(svg, "force_sensor") + 100);

  const QByteArray dot = Saved(InFolder("after.dot"));
  EXPECT_TRUE(dot.contains("layout=nop;"));
  EXPECT_EQ(dot.count("pos=\""), static_cast<qsizetype>(scene.components().size()));

  scene.nodePositions().reset();
  EXPECT_EQ(Saved(InFolder("again.svg")), before);
}

TEST_F(GraphCommandsTest, APngContainsTheWholeGraph) {
  for (int step = 0; step < 6; ++step) QTest::keyClick(&window_.graph(), Qt::Key_Plus);
  const QRectF all = window_.graph().graph().contents();

  const QImage image = QImage::fromData(Saved(InFolder("system.png")));

  ASSERT_FALSE(image.isNull());
  EXPECT_GE(image.width(), 2 * all.width());
  EXPECT_GE(image.height(), 2 * all.height());
  EXPECT_TRUE(image.save(PictureFile("graph-export")));
}

TEST_F(GraphCommandsTest, CopiesThePicture) {
  QApplication::clipboard()->clear();

  window_.findChild<QAction*>("Copy the picture of the graph")->trigger();

  EXPECT_TRUE(
      QTest::qWaitFor([] { return !QApplication::clipboard()->image().isNull(); }, kTestTimeout));
}

TEST_F(GraphCommandsTest, ReportsAFailedSave) {
  exporter().save(InFolder("system.bmp"));
  EXPECT_TRUE(Said().contains("end the file name with .svg, .png or .dot")) << Said().toStdString();

  const QString nowhere = InFolder("none/system.svg");
  exporter().save(nowhere);
  EXPECT_TRUE(QTest::qWaitFor([&] { return Said().startsWith(nowhere + " was not saved: "); },
                              kTestTimeout))
      << Said().toStdString();
}

}  // namespace
}  // namespace tendon::gui
