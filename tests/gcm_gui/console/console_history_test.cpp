#include <gcm_gui/console/console_history.h>
#include <gcm_gui/files/file_writer.h>
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kHistoryTimeout{120};

TEST(ConsoleHistory, UpAndDownWalkTheHistory) {
  ConsoleHistory history;
  history.add("ls");
  history.add("status");

  EXPECT_EQ(history.older("wat"), "status");
  EXPECT_EQ(history.older("status"), "ls");
  EXPECT_EQ(history.older("ls"), "ls");
  EXPECT_EQ(history.newer(), "status");
  EXPECT_EQ(history.newer(), "wat");
}

TEST(ConsoleHistory, SkipsEmptyAndRepeatedLines) {
  ConsoleHistory history;
  history.add("ls");
  history.add("ls");
  history.add("  ");

  EXPECT_EQ(history.lines(), QStringList{"ls"});
}

TEST(ConsoleHistory, ASearchFindsTheNewestEarlierLine) {
  ConsoleHistory history;
  for (const char* line : {"watch a", "ls", "watch b"}) history.add(line);

  EXPECT_EQ(history.find("WATCH", 99), 2);
  EXPECT_EQ(history.find("watch", 1), 0);
  EXPECT_EQ(history.find("plot", 99), -1);
}

TEST(ConsoleHistory, PersistsAcrossWindows) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("below/console");
  ConsoleHistory(file).add("ls größe");
  ASSERT_TRUE(FileWriter::instance().waitForWritten(kHistoryTimeout));

  EXPECT_EQ(ConsoleHistory(file).lines(), QStringList{"ls größe"});
}

TEST(ConsoleHistory, ReportsAFailedSaveOnce) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("console");
  ASSERT_TRUE(QDir().mkdir(file));  // a folder with the name of the file
  ConsoleHistory history(file);
  QSignalSpy notice(&history, &ConsoleHistory::notice);
  const auto add = [&](const QString& line) {
    history.add(line);
    EXPECT_TRUE(FileWriter::instance().waitForWritten(kHistoryTimeout));
    QCoreApplication::processEvents();
  };

  add("ls");
  add("status");
  ASSERT_EQ(notice.count(), 1);
  EXPECT_TRUE(notice[0][0].toString().startsWith(file + " was not saved: "));
  EXPECT_EQ(history.lines().size(), 2);

  ASSERT_TRUE(QDir().rmdir(file));
  add("top");
  EXPECT_EQ(ConsoleHistory(file).lines(), (QStringList{"ls", "status", "top"}));
  ASSERT_TRUE(QFile::remove(file) && QDir().mkdir(file));
  add("tree");
  EXPECT_EQ(notice.count(), 2);
}

}  // namespace
}  // namespace tendon::gui
