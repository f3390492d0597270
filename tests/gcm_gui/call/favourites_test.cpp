#include <gcm_gui/call/favourite_bar.h>
#include <gcm_gui/call/favourites.h>
#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/files/file_writer.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kFavouriteTimeout{120};
const Favourite kStopFavourite{"robot/controller/Control.Stop", ""};

TEST(Favourites, PersistAcrossInstances) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("below/favourites.json");
  {
    Favourites favourites(file);
    favourites.add(kStopFavourite);
    favourites.add(kStopFavourite);
    favourites.add({"a/b/C.Set", "{\"x\":1}"});
  }

  ASSERT_TRUE(FileWriter::instance().waitForWritten(kFavouriteTimeout));
  Favourites again(file);
  EXPECT_EQ(again.all(), (QList<Favourite>{kStopFavourite, {"a/b/C.Set", "{\"x\":1}"}}));
  again.remove(kStopFavourite);
  ASSERT_TRUE(FileWriter::instance().waitForWritten(kFavouriteTimeout));
  EXPECT_EQ(Favourites(file).all().size(), 1);
}

TEST(Favourites, ReportAFailedSave) {
  const QTemporaryDir folder;
  Favourites favourites(folder.path());  // the path of a folder, not of a file
  QSignalSpy notice(&favourites, &Favourites::notice);

  favourites.add(kStopFavourite);

  ASSERT_TRUE(QTest::qWaitFor([&] { return notice.count() == 1; }, 120'000));
  EXPECT_TRUE(notice[0][0].toString().startsWith(folder.path() + " was not saved: "));
  EXPECT_EQ(favourites.all().size(), 1);
}

TEST(Favourites, AButtonIsDisabledWithoutItsComponent) {
  Favourites favourites{QString()};
  CatalogueStore store;
  ScriptedCalls calls;
  FavouriteBar bar(favourites, store, calls);
  EXPECT_FALSE(bar.isVisibleTo(nullptr));
  favourites.add({"robot/tool/Grip.Open", ""});
  auto* button = bar.findChild<HoldButton*>("favourite.robot/tool/Grip.Open");
  ASSERT_NE(button, nullptr);
  EXPECT_FALSE(button->isEnabled());

  SystemBuilder system;
  ComponentDescription tool = Task("tool", 0, {});
  std::vector<ProvidedDescription> provided(tool.provided.begin(), tool.provided.end());
  provided.push_back({"Grip", {Void("Open")}, {}});
  tool.provided = provided;
  system.Process("robot").Component("robot", tool);
  store.apply(system.TakeChanges());
  EXPECT_TRUE(QTest::qWaitFor([&] { return button->isEnabled(); }, 120'000));
  QTest::mouseClick(button, Qt::LeftButton);

  EXPECT_EQ(calls.calls, QStringList{"robot/tool/Grip.Open"});
}

TEST(HoldButton, MotionCommandsMustBeHeld) {
  HoldButton button("Go");
  button.setCareful(true);
  button.show();
  QSignalSpy called(&button, &HoldButton::called);
  QSignalSpy let_go(&button, &HoldButton::releasedEarly);

  QTest::mouseClick(&button, Qt::LeftButton);
  EXPECT_EQ(called.size(), 0);
  EXPECT_EQ(let_go.size(), 1);
  QTest::mousePress(&button, Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return called.size() == 1; }, 120'000));
  QTest::mouseRelease(&button, Qt::LeftButton);

  EXPECT_EQ(called.size(), 1);
}

}  // namespace
}  // namespace tendon::gui
