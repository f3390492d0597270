#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_columns.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gtest/gtest.h>
#include <tendon/base/clock.h>

#include <QAction>
#include <QDockWidget>
#include <QFontMetrics>
#include <QHeaderView>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTest>

#include "support/picture_file.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

using Model = CatalogueModel;

class CatalogueColumnsTest : public WindowFixture {
 protected:
  ~CatalogueColumnsTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  [[nodiscard]] CatalogueTree& tree() const { return window_.catalogue().tree(); }
  [[nodiscard]] CatalogueColumns& columns() const { return tree().columns(); }
  [[nodiscard]] QList<int> seen() const {
    QList<int> seen;
    for (int column = 0; column < Model::kColumnCount; ++column) {
      if (!tree().isColumnHidden(column)) seen << column;
    }
    return seen;
  }
  [[nodiscard]] QMenu& viewMenu() const {
    const auto actions = window_.findChild<QMenuBar*>("menus")->actions();
    const auto view = std::ranges::find(actions, QStringLiteral("&View"), &QAction::text);
    return *(*view)->menu();
  }
  /// Triggers the menu entry with this text, as a user does.
  void Choose(const QString& text) const {
    for (QAction* action : viewMenu().actions()) {
      if (action->text() == text) return action->trigger();
    }
    FAIL() << "there is no " << qPrintable(text);
  }
  void Widen() {
    auto* dock = window_.findChild<QDockWidget*>("dock.Catalogue");
    window_.resize(1500, 800);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          window_.resizeDocks({dock}, {620}, Qt::Horizontal);
          return dock->width() >= 600;
        },
        kTestTimeout));
  }
  void ShowAll() const {
    for (int column = Model::kValue; column < Model::kColumnCount; ++column) {
      columns().setShown(column, true);
    }
  }
};

TEST_F(CatalogueColumnsTest, ShowsNameAndValueByDefault) {
  EXPECT_EQ(seen(), QList<int>{Model::kName});
  EXPECT_TRUE(columns().isShown(Model::kValue));
  EXPECT_TRUE(tree().isHeaderHidden());
}

TEST_F(CatalogueColumnsTest, TheViewMenuAddsAColumnWithAHeader) {
  Choose("Column: rate");

  EXPECT_EQ(seen(), (QList<int>{Model::kName, Model::kValue, Model::kRate}));
  EXPECT_FALSE(tree().isHeaderHidden());
  EXPECT_EQ(tree().header()->accessibleName(), "Columns of the catalogue");
  EXPECT_EQ(tree().model()->headerData(Model::kRate, Qt::Horizontal).toString(), "Rate");

  Choose("Column: rate");
  EXPECT_TRUE(tree().isHeaderHidden());
}

TEST_F(CatalogueColumnsTest, TheHeaderMenuChoosesColumns) {
  Choose("Column: age");
  auto* menu = tree().findChild<QMenu*>("catalogue.columnsMenu");
  ASSERT_EQ(menu->actions(), columns().actions());

  Q_EMIT tree().header()->customContextMenuRequested({4, 4});
  ASSERT_TRUE(menu->isVisible());
  QTest::keyClick(menu, Qt::Key_Down);
  QTest::keyClick(menu, Qt::Key_Return);

  EXPECT_EQ(seen(), (QList<int>{Model::kName, Model::kAge})) << "the value is left out";
}

TEST_F(CatalogueColumnsTest, RestoresTheChosenColumns) {
  columns().setShown(Model::kConnected, true);
  tree().header()->resizeSection(Model::kConnected, 99);
  columns().setShown(Model::kRate, true);
  tree().header()->resizeSection(Model::kRate, 88);
  columns().setShown(Model::kRate, false);
  const QByteArray kept = columns().state();
  columns().reset();
  ASSERT_TRUE(tree().isHeaderHidden());

  columns().restore(kept);

  EXPECT_EQ(seen(), (QList<int>{Model::kName, Model::kValue, Model::kConnected}));
  EXPECT_EQ(tree().header()->sectionSize(Model::kConnected), 99);
  columns().setShown(Model::kRate, true);
  EXPECT_EQ(tree().header()->sectionSize(Model::kRate), 88);
}

TEST_F(CatalogueColumnsTest, IgnoresAnInvalidSavedState) {
  ShowAll();
  for (const QByteArray& wrong : {QByteArray(), QByteArray("rate"), columns().state().chopped(1)}) {
    columns().restore(wrong);
    EXPECT_EQ(seen().size(), Model::kColumnCount);
  }
}

TEST_F(CatalogueColumnsTest, ResettingTheLayoutResetsTheColumns) {
  ShowAll();

  Choose("Reset layout");

  EXPECT_TRUE(tree().isHeaderHidden());
  EXPECT_EQ(seen(), QList<int>{Model::kName});
}

TEST_F(CatalogueColumnsTest, AWaitingComponentIsReadableInItsColumn) {
  Widen();
  ShowAll();
  const QString text = QStringLiteral("waiting for Robot");
  constexpr int kMarkAndInset = 16 + 2 + kInset;

  EXPECT_GE(tree().header()->sectionSize(Model::kValue),
            QFontMetrics(Theme::instance().mono()).horizontalAdvance(text) + kMarkAndInset);
  EXPECT_EQ(tree().horizontalScrollBar()->maximum(), 0);
}

TEST_F(CatalogueColumnsTest, TheNameTakesTheRemainingWidth) {
  Widen();
  columns().setShown(Model::kRate, true);
  QHeaderView& header = *tree().header();
  EXPECT_EQ(header.length(), tree().viewport()->width());
  header.resizeSection(Model::kRate, 120);
  EXPECT_EQ(header.length(), tree().viewport()->width());

  header.resizeSection(Model::kRate, 1000);
  EXPECT_GE(header.sectionSize(Model::kName), 100);
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return tree().horizontalScrollBar()->maximum() > 0; }, kTestTimeout));
}

TEST_F(CatalogueColumnsTest, RendersAllColumns) {
  Show();
  window_.show();
  ShowAll();
  Widen();
  tree().reveal("robot/arm/state.Joints");
  const auto shape =
      std::make_shared<const std::vector<NumericField>>(NumericFields(test::JointStateSchema(3)));
  const std::int64_t now = SteadyClock().Now().time_since_epoch().count();
  for (const std::uint64_t second : {0, 1, 2}) {
    Q_EMIT source_.valuesArrived("robot/arm/state.Joints",
                                 {shape,
                                  ExactValues({0.2, -0.4, 0, 0, 0, 0}),
                                  {},
                                  {},
                                  1000 * (second + 1),
                                  now + static_cast<std::int64_t>(second - 2) * 1'000'000'000});
  }
  tree().reveal("robot/arm/state.Joints.position[2]");
  for (const auto choice : {Theme::Choice::kLight, Theme::Choice::kDark}) {
    Theme::instance().choose(choice);
    QCoreApplication::processEvents();
    const QString name = choice == Theme::Choice::kLight ? "light" : "dark";
    EXPECT_TRUE(window_.grab().save(PictureFile("catalogue-columns-" + name)));
  }
}

}  // namespace
}  // namespace tendon::gui
