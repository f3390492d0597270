#include <gcm_gui/models/catalogue_filter.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gtest/gtest.h>

#include <QTest>
#include <QToolButton>
#include <cstdint>

#include "support/announcing.h"
#include "support/fakes.h"
#include "support/large_system.h"
#include "support/sample_system.h"
#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

constexpr auto kMany = "component";  // matches far more rows than a filter expands by itself
constexpr auto kManyOthers = "component_1";

/// A tree with many components; the test expands and collapses rows like a user.
class CatalogueTreeTest : public WindowFixture {
 protected:
  CatalogueTreeTest() : first_(PathOf(3, 7)), second_(PathOf(4, 9)) {
    store_.replace(LargeSystem(10, 50).catalogue());
    EXPECT_TRUE(QTest::qWaitFor([this] { return !IsAnnouncing(store_); }, kTestTimeout));
  }

  static QString PathOf(int process, int component) {
    return QString::fromStdString(LargeProcess(process) + '/' + LargeComponent(component));
  }
  [[nodiscard]] CatalogueTree& tree() const { return window_.catalogue().tree(); }
  [[nodiscard]] CatalogueFilter& filter() const {
    return *qobject_cast<CatalogueFilter*>(tree().model());
  }
  [[nodiscard]] bool isOpen(const QString& path) const {
    const QModelIndex index = filter().indexOf(path);
    EXPECT_TRUE(index.isValid()) << qPrintable(path);
    return tree().isExpanded(index);
  }
  /// Expands a collapsed row, or collapses an expanded row.
  void Turn(const QString& path) const {
    const bool open = isOpen(path);
    tree().setCurrentIndex(filter().indexOf(path));
    QTest::keyClick(&tree(), open ? Qt::Key_Left : Qt::Key_Right);
    EXPECT_NE(isOpen(path), open);
  }

  QString first_;
  QString second_;
};

TEST_F(CatalogueTreeTest, RowsOpenedByHandStayOpenUnderFilters) {
  Turn(first_);

  filter().applyText(kMany);
  EXPECT_TRUE(isOpen(first_));
  Turn(second_);
  filter().applyText(kManyOthers);
  EXPECT_TRUE(isOpen(first_));
  EXPECT_TRUE(isOpen(second_));

  filter().applyText({});
  EXPECT_TRUE(isOpen(first_));
  EXPECT_TRUE(isOpen(second_));
}

TEST_F(CatalogueTreeTest, RowsClosedUnderAFilterReopenWithoutIt) {
  Turn(first_);
  filter().applyText(kMany);

  Turn(first_);
  Turn(QString::fromStdString(LargeProcess(5)));
  filter().applyText(kManyOthers);
  EXPECT_FALSE(isOpen(first_));
  EXPECT_FALSE(isOpen(QString::fromStdString(LargeProcess(5))));

  filter().applyText({});
  EXPECT_TRUE(isOpen(first_));
  EXPECT_TRUE(isOpen(QString::fromStdString(LargeProcess(5))));
}

TEST_F(CatalogueTreeTest, RowsOpenedByAFilterCloseWithoutIt) {
  Turn(first_);

  filter().applyText(second_);
  EXPECT_TRUE(isOpen(second_));

  filter().applyText({});
  EXPECT_TRUE(isOpen(first_));
  EXPECT_FALSE(isOpen(second_));
}

/// A separate catalogue, in which `vision` is lost, with a clock that the test advances.
class HiddenProcessesTest : public ::testing::Test {
 protected:
  HiddenProcessesTest() {
    ChangedParts all;
    for (const auto& [name, entry] : catalogue_.processes()) all.insert({name, {}});
    model_.update(catalogue_, all);
    panel_.resize(300, 600);
    panel_.show();
  }

  [[nodiscard]] QToolButton& fold() const {
    return *panel_.findChild<QToolButton*>("catalogue.gone");
  }
  [[nodiscard]] bool IsSeen(const QString& path) const {
    return panel_.tree().visibleRows().contains(path);
  }
  void Pass(int seconds) { panel_.setNow(kLostSince + seconds * std::int64_t{1'000'000'000}); }

  static constexpr std::int64_t kLostSince = 1'000'000'000'000;
  const Catalogue catalogue_ = LookSystem(kLostSince).catalogue();
  CatalogueModel model_;
  CatalogueFilter filter_{model_};
  Selection selection_;
  ScriptedSignals source_;
  CataloguePanel panel_{filter_, selection_, source_};
};

TEST_F(HiddenProcessesTest, HidesProcessesThatLeftHalfAMinuteAgo) {
  Pass(29);
  EXPECT_TRUE(IsSeen("vision"));
  EXPECT_FALSE(fold().isVisible());

  Pass(30);
  EXPECT_FALSE(IsSeen("vision"));
  EXPECT_EQ(fold().text(), "▸ gone (1)");
  EXPECT_TRUE(IsSeen("robot"));

  QTest::mouseClick(&fold(), Qt::LeftButton);
  EXPECT_TRUE(IsSeen("vision"));
  EXPECT_EQ(fold().text(), "▾ gone (1)");
}

TEST_F(HiddenProcessesTest, AFilterOrASelectionShowsAHiddenProcess) {
  Pass(60);
  ASSERT_FALSE(IsSeen("vision"));

  selection_.select("vision/camera");
  EXPECT_TRUE(IsSeen("vision"));
  EXPECT_TRUE(panel_.tree().visibleRows().contains("vision/camera")) << "it is scrolled to";
  EXPECT_FALSE(fold().isVisible());
  selection_.select("robot/arm");
  EXPECT_TRUE(IsSeen("vision")) << "nothing moves under the hand";
  Pass(61);
  EXPECT_FALSE(IsSeen("vision"));

  filter_.applyText("vision");
  EXPECT_TRUE(IsSeen("vision"));
  EXPECT_FALSE(fold().isVisible());
}

TEST_F(HiddenProcessesTest, TheButtonDisappearsWithTheLastHiddenProcess) {
  Pass(60);
  ASSERT_TRUE(fold().isVisible());

  model_.update({}, {{"vision", {}}});

  EXPECT_FALSE(fold().isVisible());
}

}  // namespace
}  // namespace tendon::gui
