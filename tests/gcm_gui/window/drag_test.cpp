#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <memory>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

const QString kValue = "robot/arm/state.Joints.position[1]";

/// Tests the data of a drag and the widgets that accept it. The drag itself is done by the desktop.
class DragTest : public WindowFixture {
 protected:
  DragTest() {
    source_.send("robot/arm/state.Joints", test::JointStateSchema(2), {1, 2, 3, 4});
    window_.catalogue().tree().reveal(kValue);
  }

  /// Drops the row of the value in the middle of `place`, on the widget that is there.
  void DropOn(const QWidget& place) {
    const CatalogueTree& tree = window_.catalogue().tree();
    const QModelIndex row = tree.indexAt(tree.visibleRows().value(kValue).center());
    ASSERT_TRUE(tree.dragEnabled() && row.flags().testFlag(Qt::ItemIsDragEnabled));
    const std::unique_ptr<QMimeData> carried(tree.model()->mimeData({row}));
    const QPoint at = place.mapTo(&window_, place.rect().center());
    QWidget* taker = window_.childAt(at);
    while (taker != nullptr && !taker->acceptDrops()) taker = taker->parentWidget();
    if (taker == nullptr) return;

    const QPoint there = taker->mapFrom(&window_, at);
    QDragEnterEvent enter(there, Qt::CopyAction, carried.get(), Qt::LeftButton, {});
    QApplication::sendEvent(taker, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent drop(there, Qt::CopyAction, carried.get(), Qt::LeftButton, {});
    QApplication::sendEvent(taker, &drop);
  }
};

TEST_F(DragTest, AValueDraggedFromTheTreeToThePlotIsPlotted) {
  DropOn(window_.plots().currentPlot());

  EXPECT_EQ(window_.plots().paths(), QStringList{kValue});
}

TEST_F(DragTest, AValueDroppedElsewhereIsNotPlotted) {
  DropOn(window_.graph());

  EXPECT_TRUE(window_.plots().paths().isEmpty());
}

}  // namespace
}  // namespace tendon::gui
