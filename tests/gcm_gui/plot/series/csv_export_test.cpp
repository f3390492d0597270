#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/plot/series/csv_export.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <chrono>
#include <future>

namespace tendon::gui {
namespace {

constexpr int kTestTimeout = 120'000;  // ms; bounds a test that fails
const QString kSignalX = "robot/arm/state.x";

/// Blocks the writer, and thereby all files requested later, until release.
class SlowDisk {
 public:
  explicit SlowDisk(const QTemporaryDir& folder) {
    const auto wait = [answered = go_.get_future().share()](QIODevice&) {
      answered.wait();
      return true;
    };
    FileWriter::exports().write(folder.filePath("slow"), wait, nullptr, {});
  }
  void answer() { go_.set_value(); }

 private:
  std::promise<void> go_;
};

TEST(CsvExport, ReportsAFileThatCannotBeWritten) {
  QTemporaryDir folder;
  const QString file = folder.filePath("no/such/folder/x.csv");
  CsvExport csv;
  QSignalSpy finished(&csv, &CsvExport::finished);

  csv.save({}, file);

  ASSERT_TRUE(QTest::qWaitFor([&] { return !finished.isEmpty(); }, kTestTimeout));
  EXPECT_TRUE(finished.front().front().toString().startsWith(file + " was not saved: "));
}

TEST(CsvExport, ASlowDiskBlocksNeitherSavingNorDestruction) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("x.csv");
  SlowDisk disk(folder);

  { CsvExport().save({.curves = {{.path = kSignalX, .times = {1}, .words = {2}}}}, file); }

  EXPECT_FALSE(QFile::exists(file));
  disk.answer();
  ASSERT_TRUE(FileWriter::exports().waitForWritten(std::chrono::milliseconds(kTestTimeout)));
  EXPECT_TRUE(QFile::exists(file));
}

TEST(CsvExport, TwoRequestsForOneFileGiveOneNotice) {
  const QTemporaryDir folder;
  SlowDisk disk(folder);
  CsvExport csv;
  QSignalSpy finished(&csv, &CsvExport::finished);
  const QString file = folder.filePath("x.csv");

  csv.save({}, file);
  csv.save({.curves = {{.path = kSignalX, .times = {1}, .words = {2}}}}, file);
  disk.answer();

  ASSERT_TRUE(QTest::qWaitFor([&] { return !finished.isEmpty(); }, kTestTimeout));
  QCoreApplication::processEvents();
  ASSERT_EQ(finished.size(), 1);
  EXPECT_EQ(finished.front().front().toString(), "Saved 1 row, none lost, to " + file);
}

}  // namespace
}  // namespace tendon::gui
