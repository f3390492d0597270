#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/guard/view_cover.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/notice_line.h>
#include <qwt_plot_item.h>

#include <QAbstractScrollArea>
#include <QFile>
#include <QGraphicsItem>
#include <QGraphicsScene>
#include <QInputDialog>
#include <QPainter>
#include <QPushButton>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <stdexcept>
#include <string>

#include "guard/bomb.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

/// Object names of widgets of the window. A card and a form are opened first.
constexpr const char* kViews[] = {"catalogue",
                                  "graph",
                                  "connections",
                                  "diffPanel",
                                  "inspector",
                                  "inspector.interfaces",
                                  "inspector.values",
                                  "inspector.thread",
                                  "inspector.configuration",
                                  "call",
                                  "canvas",
                                  "plotPanel",
                                  "activity",
                                  "problems",
                                  "logPage",
                                  "log",
                                  "eventsPage",
                                  "consolePage",
                                  "lifecycleCard",
                                  "whyCard",
                                  "matchCard",
                                  "keysCard",
                                  "legend"};

QWidget& PaintedPart(QWidget& view) {
  auto* area = qobject_cast<QAbstractScrollArea*>(&view);
  return area == nullptr ? view : *area->viewport();
}

void BringIntoSight(QWidget& view) {
  for (QWidget* part = &view; part->parentWidget() != nullptr; part = part->parentWidget()) {
    auto* pages = qobject_cast<QStackedWidget*>(part->parentWidget());
    if (pages != nullptr) pages->setCurrentWidget(part);
    if (part->isHidden()) part->show();
  }
}

class GuardedViews : public WindowFixture {
 protected:
  GuardedViews() {
    window_.selection().select("robot/arm/Control.MoveTo");
    window_.plots().addSignal("robot/arm/state.Joints.position[0]", "rad");
  }
  ~GuardedViews() override {
    for (ViewCover* cover : window_.findChildren<ViewCover*>()) {
      ExceptionGuard::instance().showAgain(*cover->parentWidget());
    }
  }

  [[nodiscard]] QStringList Problems() {
    QStringList all;
    const auto* list = window_.findChild<RowView*>("problems");
    for (int row = 0; row < list->model()->rowCount(); ++row) {
      all << list->model()->index(row, 0).data().toString();
    }
    return all;
  }
  [[nodiscard]] bool WaitForProblem(const QString& words) {
    return QTest::qWaitFor([&] { return !Problems().filter(words).isEmpty(); }, kTestTimeout);
  }
  [[nodiscard]] bool WaitForNoProblem(const QString& words) {
    return QTest::qWaitFor([&] { return Problems().filter(words).isEmpty(); }, kTestTimeout);
  }
  [[nodiscard]] bool WaitForCovers(qsizetype count) {
    return QTest::qWaitFor([&] { return window_.findChildren<ViewCover*>().size() == count; },
                           kTestTimeout);
  }
  void ExpectThatTheRestIsDrawn() {
    int drawn = 0;
    QWidget& bar = *window_.findChild<NoticeLine*>();
    Bomb count(bar, QEvent::Paint, [&] {
      QPainter painter;
      drawn += painter.begin(&bar) ? 1 : 0;
    });
    bar.show();
    bar.repaint();
    EXPECT_EQ(drawn, 1);
  }
};

class EachView : public GuardedViews, public ::testing::WithParamInterface<const char*> {};

TEST_P(EachView, IsCoveredWhenItThrowsWhilePaintingAndRecovers) {
  auto* view = window_.findChild<QWidget*>(GetParam());
  ASSERT_NE(view, nullptr);
  BringIntoSight(*view);
  QWidget& painted = PaintedPart(*view);
  Bomb bomb(painted, QEvent::Paint, [] { throw std::length_error("no room in test"); });
  painted.repaint();

  ASSERT_TRUE(WaitForCovers(1)) << GetParam();
  EXPECT_TRUE(WaitForProblem("is not drawn because of an error: no room in test"));
  auto* cover = window_.findChild<ViewCover*>();
  EXPECT_TRUE(cover->parentWidget() == view || cover->parentWidget()->isAncestorOf(view));
  EXPECT_NE(cover->parentWidget(), &window_);
  const int explosions = bomb.explosions();
  for (int i = 0; i < 20; ++i) painted.repaint();
  EXPECT_EQ(bomb.explosions(), explosions);
  ExpectThatTheRestIsDrawn();

  bomb.defuse();
  cover->findChild<QPushButton*>()->click();
  const int before = bomb.events();
  BringIntoSight(*view);
  painted.repaint();

  EXPECT_GT(bomb.events(), before);
  EXPECT_TRUE(WaitForNoProblem("no room in test"));
}

TEST_P(EachView, ContinuesWhenAHandlerThrows) {
  auto* view = window_.findChild<QWidget*>(GetParam());
  ASSERT_NE(view, nullptr);
  BringIntoSight(*view);
  QWidget& part = PaintedPart(*view);
  const std::string words = std::string("pressed in ") + GetParam();
  Bomb bomb(part, QEvent::MouseButtonPress, [&] { throw std::runtime_error(words); });

  QTest::mouseClick(&part, Qt::LeftButton);

  EXPECT_EQ(bomb.explosions(), 1);
  EXPECT_TRUE(WaitForProblem(QString::fromStdString(" had an error: " + words)));
  EXPECT_TRUE(window_.findChildren<ViewCover*>().isEmpty());
}

INSTANTIATE_TEST_SUITE_P(Window, EachView, ::testing::ValuesIn(kViews), [](const auto& view) {
  std::string name(view.param);
  std::erase(name, '.');
  return name;
});

/// A delegate that throws for each row.
class ThrowingDelegate : public RowDelegate {
 public:
  using RowDelegate::RowDelegate;
  void paint(QPainter* /*painter*/, const QStyleOptionViewItem& /*option*/,
             const QModelIndex& /*index*/) const override {
    throw std::runtime_error("a row");
  }
};

TEST_F(GuardedViews, AThrowingRowCoversOnlyItsTree) {
  CatalogueTree& tree = window_.catalogue().tree();
  ThrowingDelegate delegate;
  auto* before = tree.itemDelegate();
  tree.setItemDelegate(&delegate);
  tree.viewport()->repaint();

  EXPECT_TRUE(WaitForCovers(1));
  EXPECT_TRUE(WaitForProblem("Catalogue is not drawn because of an error: a row"));
  ExpectThatTheRestIsDrawn();
  tree.setItemDelegate(before);
}

TEST_F(GuardedViews, AThrowingGraphItemCoversTheGraph) {
  struct Item : QGraphicsRectItem {
    using QGraphicsRectItem::QGraphicsRectItem;
    void paint(QPainter* /*painter*/, const QStyleOptionGraphicsItem* /*option*/,
               QWidget* /*viewport*/) override {
      throw std::runtime_error("an item");
    }
  };
  window_.graph().scene()->addItem(new Item(window_.graph().scene()->sceneRect()));
  window_.graph().viewport()->repaint();

  EXPECT_TRUE(WaitForCovers(1));
  EXPECT_TRUE(WaitForProblem("Graph is not drawn because of an error: an item"));
  ExpectThatTheRestIsDrawn();
}

class ThrowingPlotItem : public QwtPlotItem {
 public:
  explicit ThrowingPlotItem(bool& throws) : throws_(throws) {}
  void draw(QPainter* /*painter*/, const QwtScaleMap& /*x_map*/, const QwtScaleMap& /*y_map*/,
            const QRectF& /*canvas_rect*/) const override {
    if (throws_) throw std::length_error("an item of a plot");
  }

 private:
  bool& throws_;
};

TEST_F(GuardedViews, AThrowingPlotItemCoversOnlyItsPlot) {
  bool throws = true;
  PlotView& broken = window_.plots().currentPlot();
  (new ThrowingPlotItem(throws))->attach(&broken);
  PlotView& other = window_.plots().splitPlot();
  broken.replot();
  broken.canvas()->repaint();

  ASSERT_TRUE(WaitForCovers(1));
  EXPECT_NE(broken.findChild<ViewCover*>(), nullptr);
  EXPECT_EQ(other.findChild<ViewCover*>(), nullptr);
  EXPECT_TRUE(WaitForProblem("is not drawn because of an error: an item of a plot"));
  int drawn = 0;
  Bomb count(*other.canvas(), QEvent::Paint, [&] { ++drawn; });
  other.canvas()->repaint();
  EXPECT_EQ(drawn, 1);

  throws = false;
  broken.findChild<ViewCover*>()->findChild<QPushButton*>()->click();
  broken.canvas()->repaint();

  EXPECT_TRUE(WaitForCovers(0));
}

TEST_F(GuardedViews, AThrowingDialogIsCovered) {
  window_.plots().askForName();
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog, kTestTimeout));
  Bomb bomb(*dialog, QEvent::Paint, [] { throw std::runtime_error("a dialog"); });
  dialog->repaint();

  EXPECT_TRUE(WaitForProblem("Rename this plot is not drawn because of an error: a dialog"));
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return dialog->findChild<ViewCover*>() != nullptr; }, kTestTimeout));
  dialog->close();
}

TEST_F(GuardedViews, AThrowingReceiverDoesNotStopModelUpdates) {
  // A receiver of the model's signals runs inside the slot that changes the model.
  QObject::connect(&window_.catalogueModel(), &QAbstractItemModel::rowsInserted, &window_,
                   [] { throw std::runtime_error("a model"); });
  const auto* connections = window_.findChild<RowView*>("connections");
  const int before = connections->model()->rowCount();

  system_.Process("new").Component("new", Task("component", 0.01, {}));
  system_.Disconnect({"robot", "controller", "Arm"});
  store_.apply(system_.TakeChanges());

  EXPECT_TRUE(WaitForProblem("Catalogue had an error: a model"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return connections->model()->rowCount() == before - 1; },
                              kTestTimeout));
}

TEST_F(GuardedViews, AFailingLayoutIsReported) {
  QTemporaryDir folder;
  QFile file(folder.filePath("layout.json"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"version": 1, "plots": [{"window": 30, "curves": [
      {"path": "robot/arm/state.Joints.position[1]", "unit": "rad"}]}]})");
  file.close();
  QObject::connect(&window_.plots(), &PlotPanel::subscriptionWanted, &window_,
                   [] { throw std::length_error("cannot create"); });

  window_.plots().files().openLayout(file.fileName());

  EXPECT_TRUE(WaitForProblem("Plots had an error: cannot create"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return window_.findChild<NoticeLine*>()->text().contains("cannot be shown: cannot create");
      },
      kTestTimeout));
}

}  // namespace
}  // namespace tendon::gui
