#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_picture.h>
#include <gcm_gui/plot/plot_view.h>
#include <gmock/gmock.h>

#include <QClipboard>
#include <QContextMenuEvent>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "../samples.h"

namespace tendon::gui {
namespace {

class PlotMenuTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.resize(800, 320);
    panel_.addSignal("p/a/state.x", "rad");
    panel_.append("p/a/state.x", Rows(0, 30'000, [](double t) { return 1 + std::sin(t); }));
    panel_.show();
    view().refresh();
  }

  PlotView& view() { return panel_.currentPlot(); }
  /// Opens the menu with its key, and triggers the action with this text.
  void Choose(const QString& text) {
    const QPoint place(40, 40);
    QContextMenuEvent key(QContextMenuEvent::Keyboard, place, view().canvas()->mapToGlobal(place));
    QCoreApplication::sendEvent(view().canvas(), &key);
    auto* menu = panel_.findChild<QMenu*>("plotMenu");
    ASSERT_NE(menu, nullptr);
    for (QAction* action : menu->findChildren<QAction*>()) {
      if (action->text() == text) action->trigger();
    }
    delete menu;
    view().refresh();
  }
  [[nodiscard]] AxisRange range() { return view().curves().axes().front().range; }

  PlotPanel panel_;
};

TEST_F(PlotMenuTest, FitsValuesAsChosen) {
  Choose("Symmetric around 0");
  EXPECT_DOUBLE_EQ(range().low, -range().high);

  Choose("Only grow");
  const AxisRange before = range();
  panel_.append("p/a/state.x", Rows(30'000, 100'000, [](double) { return 1.0; }));
  view().refresh();
  EXPECT_EQ(range(), before);

  Choose("Fit the visible part");
  EXPECT_LT(range().span(), before.span());
}

TEST_F(PlotMenuTest, StatisticsCoverTheVisibleTime) {
  Choose("Statistics");

  const QString figures = view().legendBox().rows().front()->entry().figures;

  EXPECT_THAT(figures.toStdString(), testing::HasSubstr("max"));
  EXPECT_THAT(figures.toStdString(), testing::HasSubstr("1000 Hz"));
}

TEST_F(PlotMenuTest, CopiesThePicture) {
  Choose("Copy picture");

  EXPECT_EQ(QGuiApplication::clipboard()->image().size(), view().size());
}

TEST_F(PlotMenuTest, SavesThePictureAsPixelsOrVectors) {
  const QTemporaryDir folder;
  const auto save = [this](const QString& file) {
    QString told;
    SavePicture(view(), file, &view(), [&told](const QString& sentence) { told = sentence; });
    EXPECT_TRUE(QTest::qWaitFor([&told] { return !told.isEmpty(); }, 120'000));
    return told;
  };

  EXPECT_EQ(save(folder.filePath("a.png")), folder.filePath("a.png") + " saved");
  EXPECT_EQ(QImage(folder.filePath("a.png")).size(), view().size() * 2);
  EXPECT_EQ(save(folder.filePath("a.svg")), folder.filePath("a.svg") + " saved");
  QFile svg(folder.filePath("a.svg"));
  ASSERT_TRUE(svg.open(QIODevice::ReadOnly));
  const std::string text = svg.readAll().toStdString();
  EXPECT_THAT(text, testing::HasSubstr("<path"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("<image")));
  EXPECT_THAT(save("/no/such/folder/a.png").toStdString(), testing::HasSubstr("was not saved"));
}

}  // namespace
}  // namespace tendon::gui
