#include <gcm_gui/console/console_history.h>
#include <gtest/gtest.h>

#include <QTemporaryDir>

namespace tendon::gui {
namespace {

TEST(ConsoleHistory, UpGoesBackAndDownComesToWhatWasTyped) {
  ConsoleHistory history;
  history.add("ls");
  history.add("status");

  EXPECT_EQ(history.older("wat"), "status");
  EXPECT_EQ(history.older("status"), "ls");
  EXPECT_EQ(history.older("ls"), "ls");
  EXPECT_EQ(history.newer(), "status");
  EXPECT_EQ(history.newer(), "wat");
}

TEST(ConsoleHistory, EmptyLinesAndRepetitionsAreNotKept) {
  ConsoleHistory history;
  history.add("ls");
  history.add("ls");
  history.add("  ");

  EXPECT_EQ(history.lines(), QStringList{"ls"});
}

TEST(ConsoleHistory, ASearchFindsTheNewestBeforeAPlace) {
  ConsoleHistory history;
  for (const char* line : {"watch a", "ls", "watch b"}) history.add(line);

  EXPECT_EQ(history.find("WATCH", 99), 2);
  EXPECT_EQ(history.find("watch", 1), 0);
  EXPECT_EQ(history.find("plot", 99), -1);
}

TEST(ConsoleHistory, TheNextWindowKnowsWhatWasTyped) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("below/console");
  ConsoleHistory(file).add("ls größe");

  EXPECT_EQ(ConsoleHistory(file).lines(), QStringList{"ls größe"});
}

}  // namespace
}  // namespace tendon::gui
