#include <gcm_gui/window/panels.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QTest>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

class PanelsTest : public WindowFixture {
 protected:
  [[nodiscard]] QDockWidget& dock(const QString& title) const {
    return *window_.findChild<QDockWidget*>("dock." + title);
  }
  [[nodiscard]] Qt::DockWidgetArea AreaOf(const QString& title) const {
    return window_.dockWidgetArea(&dock(title));
  }

  /// Drags the panel by its title to a position in the window, as a user would.
  void Drag(QDockWidget& dock, const QPoint& to) {
    const QPoint grip(40, 8);
    const QPoint from = dock.mapTo(&window_, grip);
    QTest::mousePress(&dock, Qt::LeftButton, {}, grip);
    constexpr int kSteps = 12;
    for (int step = 1; step <= kSteps; ++step) {
      const QPoint at = window_.mapToGlobal(from + (to - from) * step / kSteps);
      QTest::mouseMove(&dock, dock.mapFromGlobal(at));
      QCoreApplication::processEvents();
    }
    QTest::mouseRelease(&dock, Qt::LeftButton, {}, dock.mapFromGlobal(window_.mapToGlobal(to)));
    QCoreApplication::processEvents();
  }
};

TEST_F(PanelsTest, AMovablePanelCanBeDragged) {
  window_.panels().setMovable(true);
  ASSERT_EQ(AreaOf("Inspector"), Qt::RightDockWidgetArea);

  Drag(dock("Inspector"), {8, window_.height() / 2});

  EXPECT_EQ(AreaOf("Inspector"), Qt::LeftDockWidgetArea);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !dock("Inspector").isFloating(); }, kTestTimeout));
  EXPECT_TRUE(dock("Inspector").isVisible());
}

TEST_F(PanelsTest, RestoresThePlaceOfAPanel) {
  window_.addDockWidget(Qt::LeftDockWidgetArea, &dock("Inspector"));
  const QByteArray kept = window_.panels().state();

  window_.panels().reset();
  EXPECT_EQ(AreaOf("Inspector"), Qt::RightDockWidgetArea);
  window_.panels().restore(kept);

  EXPECT_EQ(AreaOf("Inspector"), Qt::LeftDockWidgetArea);
}

TEST_F(PanelsTest, AFixedPanelCannotBeDragged) {
  Drag(dock("Inspector"), {8, window_.height() / 2});

  EXPECT_EQ(AreaOf("Inspector"), Qt::RightDockWidgetArea);
}

}  // namespace
}  // namespace tendon::gui
