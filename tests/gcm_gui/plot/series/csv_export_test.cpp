#include <gcm_gui/files/file_writer.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/series/csv_export.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <chrono>
#include <future>

#include "../samples.h"

namespace tendon::gui {
namespace {

constexpr int kPatience = 120'000;  // ms; bounds a test that fails
const QString kSignalX = "robot/arm/state.x";

class CsvExportTest : public ::testing::Test {
 protected:
  CsvExportTest() {
    panel_.resize(800, 320);
    panel_.show();
  }

  [[nodiscard]] QFileDialog* Ask() {
    QTest::mouseClick(panel_.findChild<QToolButton*>("saveCsv"), Qt::LeftButton);
    return panel_.findChild<QFileDialog*>();
  }

  QTemporaryDir folder_;
  PlotPanel panel_;
  QSignalSpy told_{&panel_, &PlotPanel::notice};
};

TEST_F(CsvExportTest, SavesTheVisibleSamplesToTheChosenFile) {
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  panel_.addSignal(kSignalX, "rad");
  panel_.append(kSignalX, Rows(0, 1000));
  panel_.currentPlot().refresh();
  QFileDialog* dialog = Ask();
  ASSERT_NE(dialog, nullptr);
  const QString file = folder_.filePath("arm.csv");

  dialog->selectFile(file);
  QMetaObject::invokeMethod(dialog, "accept");

  ASSERT_TRUE(QTest::qWaitFor([&] { return !told_.isEmpty(); }, kPatience));
  EXPECT_EQ(told_.front().front().toString(), "Saved 1000 rows, none lost, to " + file);
  QFile saved(file);
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_EQ(saved.readAll().count('\n'), 1001);
}

TEST_F(CsvExportTest, DoesNotAskForAFileWithoutSamples) {
  EXPECT_EQ(Ask(), nullptr);

  ASSERT_EQ(told_.size(), 1);
  EXPECT_TRUE(told_.front().front().toString().startsWith("There is nothing to save"));
}

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

  ASSERT_TRUE(QTest::qWaitFor([&] { return !finished.isEmpty(); }, kPatience));
  EXPECT_TRUE(finished.front().front().toString().startsWith(file + " was not saved: "));
}

TEST(CsvExport, ASlowDiskBlocksNeitherSavingNorDestruction) {
  const QTemporaryDir folder;
  const QString file = folder.filePath("x.csv");
  SlowDisk disk(folder);

  { CsvExport().save({.curves = {{.path = kSignalX, .times = {1}, .words = {2}}}}, file); }

  EXPECT_FALSE(QFile::exists(file));
  disk.answer();
  ASSERT_TRUE(FileWriter::exports().waitForWritten(std::chrono::milliseconds(kPatience)));
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

  ASSERT_TRUE(QTest::qWaitFor([&] { return !finished.isEmpty(); }, kPatience));
  QCoreApplication::processEvents();
  ASSERT_EQ(finished.size(), 1);
  EXPECT_EQ(finished.front().front().toString(), "Saved 1 row, none lost, to " + file);
}

}  // namespace
}  // namespace tendon::gui
